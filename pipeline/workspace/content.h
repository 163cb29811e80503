#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lumi {

/// A file by what is in it, wherever it lies and whenever it was written.
struct ContentEntry {
    std::string name;  ///< Relative, '/' between folders.
    std::string sha256;
    friend bool operator==(const ContentEntry&, const ContentEntry&) = default;
};

/// The content of one file, or of every regular file below a folder, sorted by name; hidden files
/// and folders that may not be read excepted, and `working_folder` should it lie below. Nothing
/// when the path does not exist. Throws Error (E-FILE-READ).
[[nodiscard]] std::vector<ContentEntry> content_of(
    const std::filesystem::path& file_or_folder, int threads,
    const std::filesystem::path& working_folder = {});

/// What of a video or a folder of photographs decides what is made of it: of a folder the
/// photographs that list_photographs finds, and which pictures it leaves out and why. Whatever else
/// lies there may come, go and change, and so may what `other_folders` hold. Throws Error
/// (E-FILE-READ, E-INGEST-NOFOLDER).
[[nodiscard]] std::vector<ContentEntry> content_of_photographs(
    const std::filesystem::path& photographs_or_video, const std::filesystem::path& working_folder,
    const std::vector<std::filesystem::path>& other_folders, int threads);

/// One hash over names and contents.
[[nodiscard]] std::string sha256_of_content(const std::vector<ContentEntry>& entries);

}  // namespace lumi
