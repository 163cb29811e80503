#include "pipeline/workspace/work_folder.h"

#include <algorithm>

#include "calib/ingest/made_by_lumi.h"
#include "calib/work/whole_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

bool holds_nothing(const fs::path& folder) {
    std::error_code status;
    const fs::directory_iterator entries(folder, status);
    return std::all_of(begin(entries), end(entries), [](const fs::directory_entry& entry) {
        return entry.path().filename().string().starts_with('.');
    });
}

const fs::path& marked(const fs::path& folder, const std::vector<std::string>& known) {
    const bool is_ours = is_made_by_lumi(folder) || holds_nothing(folder) ||
                         std::any_of(known.begin(), known.end(), [&](const std::string& name) {
                             std::error_code status;
                             return fs::exists(folder / name, status);
                         });
    if (!is_ours)
        refuse_loss(folder, "holds what lumi did not make, and would count as made by it");
    mark_as_made_by_lumi(folder);
    return folder;
}

}  // namespace

WorkFolder::WorkFolder(const fs::path& folder, const std::vector<std::string>& known)
    : lock_(marked(folder, known)) {}

}  // namespace lumi
