#include "calib/work/content_hash.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <vector>

#include "calib/work/error.h"

namespace lumi {
namespace {

/// A hash that bytes are fed to, block by block.
class Sha256 {
 public:
    Sha256() { EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr); }

    void add(std::span<const std::uint8_t> bytes) {
        EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size());
    }

    [[nodiscard]] std::string hex() {
        std::array<unsigned char, 32> digest{};
        EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr);
        constexpr char kDigits[] = "0123456789abcdef";
        std::string hex;
        for (const unsigned char byte : digest) {
            hex += kDigits[byte >> 4];
            hex += kDigits[byte & 15];
        }
        return hex;
    }

 private:
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_{EVP_MD_CTX_new(),
                                                                     &EVP_MD_CTX_free};
};

[[noreturn]] void refuse_to_hash(const std::filesystem::path& path, const std::string& reason) {
    throw Error(ErrorKind::kBadInput, "E-FILE-READ", path.string() + ": " + reason,
                "check that the file exists and that you may read it");
}

}  // namespace

std::string sha256_hex(std::span<const std::uint8_t> bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.hex();
}

std::string sha256_hex(std::string_view text) {
    return sha256_hex(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::string sha256_hex_of_file(const std::filesystem::path& path) {
    std::error_code status;
    // Anything else that can be opened might have no end.
    if (!std::filesystem::is_regular_file(path, status)) refuse_to_hash(path, "not a file");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) refuse_to_hash(path, "cannot be opened");
    constexpr std::size_t kBlockBytes = std::size_t{1} << 20;
    std::vector<std::uint8_t> block(kBlockBytes);
    Sha256 hash;
    while (stream) {
        stream.read(reinterpret_cast<char*>(block.data()), kBlockBytes);
        hash.add(std::span(block).first(static_cast<std::size_t>(stream.gcount())));
    }
    if (!stream.eof()) refuse_to_hash(path, "cannot be read to its end");
    return hash.hex();
}

}  // namespace lumi
