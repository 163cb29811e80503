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
/// excepted. Nothing when the path does not exist.
[[nodiscard]] std::vector<ContentEntry> content_of(const std::filesystem::path& file_or_folder,
                                                   int threads);

/// One hash over names and contents.
[[nodiscard]] std::string sha256_of_content(const std::vector<ContentEntry>& entries);

}  // namespace lumi
