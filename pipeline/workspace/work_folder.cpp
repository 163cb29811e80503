#include "pipeline/workspace/work_folder.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/ingest/made_by_lumi.h"
#include "calib/work/error.h"
#include "calib/work/whole_folder.h"
#include "pipeline/workspace/json_file.h"
#include "pipeline/workspace/workspace.h"
#include "render/lumigraph/manifest.h"

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

using IsOfEarlyVersion = std::function<bool(const fs::path&)>;

const fs::path& marked(const fs::path& folder, const IsOfEarlyVersion& is_of_early_version) {
    std::error_code status;
    if (fs::exists(folder / kManifestName, status))
        refuse_loss(folder, "is a package, and no folder to work in");
    if (!is_made_by_lumi(folder) && !holds_nothing(folder) && !is_of_early_version(folder))
        refuse_loss(folder, "holds what lumi did not make, and would count as made by it");
    mark_as_made_by_lumi(folder);
    return folder;
}

}  // namespace

WorkFolder::WorkFolder(const fs::path& folder, const IsOfEarlyVersion& is_of_early_version)
    : lock_(marked(folder, is_of_early_version)) {}

bool is_record_of_lumi(const fs::path& path) {
    std::error_code status;
    if (!fs::is_regular_file(path, status)) return false;
    try {
        return read_json_file(path).contains("schema_version");
    } catch (const Error&) {
        return false;
    }
}

bool holds_workspace(const fs::path& folder) {
    std::error_code status;
    const fs::directory_iterator entries(folder, status);
    return std::any_of(begin(entries), end(entries),
                       [](const fs::directory_entry& entry) { return is_workspace(entry.path()); });
}

}  // namespace lumi
