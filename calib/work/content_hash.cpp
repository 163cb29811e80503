#include "calib/work/content_hash.h"

#include <openssl/evp.h>

#include <array>

#include "calib/work/whole_file.h"

namespace lumi {

std::string sha256_hex(std::span<const std::uint8_t> bytes) {
    std::array<unsigned char, 32> digest{};
    unsigned int length = 0;
    EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr);
    constexpr char kDigits[] = "0123456789abcdef";
    std::string hex;
    for (const unsigned char byte : digest) {
        hex += kDigits[byte >> 4];
        hex += kDigits[byte & 15];
    }
    return hex;
}

std::string sha256_hex(std::string_view text) {
    return sha256_hex(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::string sha256_hex_of_file(const std::filesystem::path& path) {
    return sha256_hex(std::span<const std::uint8_t>(read_whole_file(path)));
}

}  // namespace lumi
