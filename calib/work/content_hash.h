#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace lumi {

/// SHA-256 in lower-case hexadecimal.
[[nodiscard]] std::string sha256_hex(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::string sha256_hex(std::string_view text);
/// Of a regular file, however large: it is read block by block. Throws Error (E-FILE-READ).
[[nodiscard]] std::string sha256_hex_of_file(const std::filesystem::path& path);

}  // namespace lumi
