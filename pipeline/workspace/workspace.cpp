#include "pipeline/workspace/workspace.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "calib/ingest/made_by_lumi.h"
#include "calib/work/config_section.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "pipeline/workspace/done_marker.h"
#include "pipeline/workspace/json_file.h"
#include "pipeline/workspace/stage_outputs.h"
#include "render/lumigraph/manifest.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const WorkspaceLayout& layout) {
    return {layout.config_path(), layout.stages_path(), layout.report_path()};
}

/// A folder of the workspace, and the file that lumi leaves in it.
struct MarkedFolder {
    fs::path path;
    const char* marker;
};

/// All but the package, whose writer tells for itself what it replaces.
std::vector<MarkedFolder> marked_folders_of(const WorkspaceLayout& layout) {
    std::vector<MarkedFolder> folders{{layout.evaluation_folder(), kEvaluationName},
                                      {layout.stage_folder("plan"), kPlanName}};
    for (const char* stage : kAllStages)
        folders.push_back({layout.stage_folder(stage), kDoneMarkerName});
    return folders;
}

bool has_lock(const WorkspaceLayout& layout) {
    std::error_code status;
    return fs::exists(layout.folder() / kLockName, status);
}

bool has_own_configuration(const WorkspaceLayout& layout) {
    std::error_code status;
    return fs::is_regular_file(layout.config_path(), status) &&
           read_whole_text(layout.config_path()).starts_with(kWorkspaceConfigHeader);
}

bool has_record_of_runs(const WorkspaceLayout& layout) {
    try {
        const auto run = read_json_file(layout.stages_path());
        return run.contains("schema_version") && run.contains("configuration_sha256");
    } catch (const Error&) {
        return false;
    }
}

/// Who edits or converts a configuration still has a workspace.
bool is_known_for_workspace(const WorkspaceLayout& layout) {
    return has_own_configuration(layout) ||
           (has_record_of_runs(layout) && has_finished_stage(layout));
}

void expect_nothing_at(const fs::path& path, const std::string& more_advice = "") {
    std::error_code status;
    if (!fs::exists(fs::symlink_status(path, status))) return;
    throw Error(ErrorKind::kBadInput, "E-WORKSPACE-FOREIGN",
                path.string() + ": would be replaced, and nothing tells that lumi wrote it",
                "give it another name or move it elsewhere" + more_advice +
                    "; lumi build can work in another folder, too, with --workspace");
}

void expect_no_folder_at(const fs::path& path) {
    expect_nothing_at(path, ", or remove it, if an earlier run of lumi left it");
}

bool is_lumis_own(const MarkedFolder& folder) {
    std::error_code status;
    if (fs::is_directory(folder.path, status) && fs::is_empty(folder.path, status)) return true;
    return fs::is_regular_file(folder.path / folder.marker, status) ||
           is_marked_as_made_by_lumi(folder.path);
}

/// Somebody's dataset may well have a folder that is called depth and a file config.toml, also
/// beside a lock: that of another program, or of a run that ended before it wrote anything. What
/// lies in a folder has to say so itself: whoever wants a stage to run again removes its marker,
/// which leaves the mark of what lumi made.
WorkspaceLayout without_foreign_files(const WorkspaceLayout& layout) {
    const bool is_known = is_known_for_workspace(layout);
    const bool may_hold_ours = is_known || has_lock(layout);
    if (!may_hold_ours) expect_no_folder_at(layout.package_folder());
    for (const MarkedFolder& folder : marked_folders_of(layout)) {
        if (!may_hold_ours || !is_lumis_own(folder)) expect_no_folder_at(folder.path);
    }
    if (is_known) return layout;
    for (const fs::path& file : files_of(layout)) expect_nothing_at(file);
    return layout;
}

void remove_leftovers(const WorkspaceLayout& layout) {
    for (const fs::path& file : files_of(layout)) remove_unfinished_siblings(file);
    for (const MarkedFolder& folder : marked_folders_of(layout))
        clean_up_after_killed_runs(folder.path);
    clean_up_after_killed_runs(layout.package_folder());
}

fs::path without_slash_at_end(const fs::path& folder) {
    return folder.has_filename() ? folder : folder.parent_path();
}

fs::path with_name_of_its_own(const fs::path& folder) {
    const fs::path path = without_slash_at_end(folder);
    const bool is_pointed_at = path.filename() == "." || path.filename() == "..";
    return is_pointed_at ? without_slash_at_end(fs::weakly_canonical(path)) : path;
}

}  // namespace

WorkspaceLayout::WorkspaceLayout(const fs::path& folder, std::string name)
    : folder_(with_name_of_its_own(folder)), name_(std::move(name)) {}

Workspace::Workspace(const WorkspaceLayout& layout)
    : WorkspaceLayout(without_foreign_files(layout)), lock_(layout.folder()) {
    remove_leftovers(layout);
}

bool has_finished_stage(const WorkspaceLayout& layout) {
    return std::any_of(kAllStages.begin(), kAllStages.end(), [&](const char* stage) {
        return read_done_marker(layout.stage_folder(stage) / kDoneMarkerName).has_value();
    });
}

std::filesystem::path folder_around(const std::filesystem::path& package_folder) {
    const auto path = std::filesystem::absolute(package_folder).lexically_normal();
    const bool ends_in_slash = !path.has_filename();
    return ends_in_slash ? path.parent_path().parent_path() : path.parent_path();
}

bool is_workspace(const fs::path& folder) {
    const WorkspaceLayout layout(folder, "");
    std::error_code status;
    return fs::is_regular_file(layout.config_path(), status) && is_known_for_workspace(layout);
}

WorkspaceLayout find_workspace(const fs::path& folder) {
    const fs::path config_path = WorkspaceLayout(folder, "").config_path();
    std::error_code status;
    // A package has a config.toml, too: that of its workspace.
    if (fs::is_regular_file(folder / kManifestName, status)) {
        throw Error(ErrorKind::kBadInput, "E-WORKSPACE-NONE",
                    folder.string() + ": is a package, where a workspace is expected",
                    "name the folder that `lumi build` made it in, such as work/NAME");
    }
    if (!is_workspace(folder)) {
        const bool has_configuration = fs::is_regular_file(config_path, status);
        throw Error(ErrorKind::kBadInput, "E-WORKSPACE-NONE",
                    folder.string() + ": no workspace of lumi (" +
                        (has_configuration ? "nothing tells that lumi wrote its config.toml"
                                           : "it has no config.toml") +
                        ")",
                    "name the folder that `lumi build` wrote, such as work/NAME");
    }
    return {folder, ConfigSection::from_file(config_path).text("name", "")};
}

}  // namespace lumi
