#include "pipeline/workspace/content.h"

#include <algorithm>

#include "calib/ingest/photograph_folder.h"
#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

struct NamedFile {
    std::string name;  ///< As in ContentEntry.
    fs::path path;
};

std::vector<NamedFile> files_below(const fs::path& folder, const fs::path& working_folder) {
    std::vector<NamedFile> files;
    std::error_code status;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                           status);
    for (; !status && entry != fs::recursive_directory_iterator(); entry.increment(status)) {
        std::error_code ignored;  // A link to itself is no file, and no reason to end.
        const bool is_ours =
            entry->is_directory(ignored) && fs::equivalent(entry->path(), working_folder, ignored);
        if (is_ours || is_hidden(entry->path())) {
            entry.disable_recursion_pending();
        } else if (entry->is_regular_file(ignored)) {
            files.push_back(
                {entry->path().lexically_relative(folder).generic_string(), entry->path()});
        }
    }
    if (status) {
        throw Error(ErrorKind::kBadInput, "E-FILE-READ", folder.string() + ": " + status.message(),
                    "check that you may read the folder");
    }
    return files;
}

/// Sorted by name.
std::vector<ContentEntry> contents(const std::vector<NamedFile>& files, int threads) {
    std::vector<ContentEntry> entries(files.size());
    parallel_for(static_cast<int>(files.size()), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        entries[index] = {files[index].name, sha256_hex_of_file(files[index].path)};
    });
    std::sort(entries.begin(), entries.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
    return entries;
}

}  // namespace

std::vector<ContentEntry> content_of(const fs::path& file_or_folder, int threads,
                                     const fs::path& working_folder) {
    std::error_code status;
    if (fs::is_directory(file_or_folder, status)) {
        return contents(files_below(file_or_folder, working_folder), threads);
    }
    if (!fs::is_regular_file(file_or_folder, status)) return {};
    return contents({{file_or_folder.filename().string(), file_or_folder}}, threads);
}

std::vector<ContentEntry> content_of_photographs(const fs::path& photographs_or_video,
                                                 const fs::path& working_folder,
                                                 const std::vector<fs::path>& other_folders,
                                                 int threads) {
    std::error_code status;
    if (fs::is_regular_file(photographs_or_video, status)) {
        return content_of(photographs_or_video, threads);
    }
    const PhotographFolder folder =
        list_photographs(photographs_or_video, working_folder, other_folders);
    std::vector<NamedFile> files;
    for (const PhotographFile& file : folder.files) files.push_back({file.name, file.path});
    std::vector<ContentEntry> entries = contents(files, threads);
    for (const LeftOut& picture : folder.left_out) {
        entries.push_back({picture.name, sha256_hex(picture.code + ": " + picture.reason)});
    }
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
