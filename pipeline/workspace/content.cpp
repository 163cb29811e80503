#include "pipeline/workspace/content.h"

#include <algorithm>

#include "calib/work/content_hash.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    for (auto entry = fs::recursive_directory_iterator(folder);
         entry != fs::recursive_directory_iterator(); ++entry) {
        if (is_hidden(entry->path())) {
            entry.disable_recursion_pending();
        } else if (entry->is_regular_file()) {
            files.push_back(entry->path());
        }
    }
    return files;
}

}  // namespace

std::vector<ContentEntry> content_of(const fs::path& file_or_folder, int threads) {
    std::error_code status;
    std::vector<fs::path> files;
    fs::path base = file_or_folder;
    if (fs::is_directory(file_or_folder, status)) {
        files = files_below(file_or_folder);
    } else if (fs::is_regular_file(file_or_folder, status)) {
        files = {file_or_folder};
        base = file_or_folder.parent_path();
    }
    std::vector<ContentEntry> entries(files.size());
    parallel_for(static_cast<int>(files.size()), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        entries[index] = {files[index].lexically_relative(base).generic_string(),
                          sha256_hex_of_file(files[index])};
    });
    std::sort(entries.begin(), entries.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
    return entries;
}

std::string sha256_of_content(const std::vector<ContentEntry>& entries) {
    std::string text;
    for (const ContentEntry& entry : entries) {
        // Lengths first, so that no two lists read the same.
        text += std::to_string(entry.name.size()) + ':' + entry.name + entry.sha256;
    }
    return sha256_hex(text);
}

}  // namespace lumi
