#include "pipeline/workspace/stage_outputs.h"

#include <algorithm>

#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

bool is_unharmed(const fs::path& path, const std::string& sha256) {
    std::error_code status;
    if (!fs::is_regular_file(path, status)) return false;
    try {
        return sha256_hex_of_file(path) == sha256;
    } catch (const Error&) {
        return false;  // Unreadable: as good as lost.
    }
}

}  // namespace

bool are_unharmed(const fs::path& workspace_folder, const std::vector<ContentEntry>& outputs,
                  int threads) {
    std::vector<char> unharmed(outputs.size(), 0);
    parallel_for(static_cast<int>(outputs.size()), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const ContentEntry& output = outputs[index];
        unharmed[index] = is_unharmed(workspace_folder / output.name, output.sha256) ? 1 : 0;
    });
    return std::all_of(unharmed.begin(), unharmed.end(), [](char ok) { return ok != 0; });
}

bool are_unharmed(const fs::path& stage_folder, const std::string& stage,
                  const std::vector<ContentEntry>& outputs, int threads) {
    const std::string prefix = stage + '/';
    std::vector<ContentEntry> within;
    for (const ContentEntry& output : outputs) {
        if (!output.name.starts_with(prefix)) return false;
        within.push_back({output.name.substr(prefix.size()), output.sha256});
    }
    return are_unharmed(stage_folder, within, threads);
}

}  // namespace lumi
