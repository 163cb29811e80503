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
/// The same as text, without a byte order mark.
[[nodiscard]] std::string read_whole_text(const std::filesystem::path& path,
                                          std::size_t max_bytes = std::size_t{1} << 30);

/// UTF-8 text without the mark that editors on Windows let it begin with.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text);

/// Writes a file whole or not at all: a hidden temporary sibling, fsync, rename, fsync of the
/// folder. Missing parent folders are made. Throws Error (E-FILE-WRITE; kind kResources when the
/// disk is full) and leaves what was there before untouched.
void write_whole_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_whole_text(const std::filesystem::path& path, std::string_view text);

/// For before long work: throws what write_whole_file would, as far as that can be told by now,
/// and makes nothing.
void require_writable_file(const std::filesystem::path& path);
/// The same for files of any name in a folder, which may have to be made.
void require_writable_folder(const std::filesystem::path& folder);

/// Puts a file that another program made on the same file system in its place: flushed and renamed.
/// Throws Error (E-FILE-WRITE) and leaves what was there before untouched.
void put_whole_file(const std::filesystem::path& made, const std::filesystem::path& path);

/// Removes temporary siblings that a killed run left beside the file. To be called by who knows
/// that no other run writes it.
void remove_unfinished_siblings(const std::filesystem::path& path);

/// Flushes a folder's list of names to the disk, where the file system can.
void flush_folder(const std::filesystem::path& folder);

/// Throws Error (E-FILE-WRITE; kind kResources when the disk is full) for a value of errno.
[[noreturn]] void refuse_write(const std::filesystem::path& path, int error_number);

}  // namespace lumi
