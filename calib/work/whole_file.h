#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lumi {

using Bytes = std::vector<std::uint8_t>;

/// The bytes of a regular file. Throws Error (E-FILE-READ, E-FILE-TOOBIG) naming the path.
[[nodiscard]] Bytes read_whole_file(const std::filesystem::path& path,
                                    std::size_t max_bytes = std::size_t{4} << 30);
[[nodiscard]] std::string read_whole_text(const std::filesystem::path& path,
                                          std::size_t max_bytes = std::size_t{1} << 30);

/// Writes a file whole or not at all: a temporary sibling, fsync, rename, fsync of the folder.
/// Missing parent folders are made. Throws Error (E-FILE-WRITE; kind kResources when the disk is
/// full) and leaves what was there before untouched.
void write_whole_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_whole_text(const std::filesystem::path& path, std::string_view text);

}  // namespace lumi
