#include "pipeline/workspace/workspace.h"

#include <vector>

#include "calib/work/config_section.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "pipeline/workspace/stage_outputs.h"
#include "render/lumigraph/manifest.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

const fs::path& made(const fs::path& folder) {
    std::error_code status;
    fs::create_directories(folder, status);
    if (status) {
        throw Error(ErrorKind::kBadInput, "E-FILE-WRITE",
                    folder.string() + ": cannot make the folder: " + status.message(),
                    "choose a folder you may write to with --workspace");
    }
    return folder;
}

std::vector<fs::path> files_of(const WorkspaceLayout& layout) {
    return {layout.config_path(), layout.stages_path(), layout.report_path()};
}

std::vector<fs::path> folders_of(const WorkspaceLayout& layout) {
    std::vector<fs::path> folders{layout.evaluation_folder(), layout.package_folder()};
    for (const char* stage : {"ingest", "calibrate", "poses", "mesh", "depth", "pack", "plan"})
        folders.push_back(layout.stage_folder(stage));
    return folders;
}

/// Its lock tells; where it was copied without, its configuration.
bool is_workspace(const WorkspaceLayout& layout) {
    std::error_code status;
    if (fs::exists(layout.folder() / kLockName, status)) return true;
    return fs::is_regular_file(layout.config_path(), status) &&
           read_whole_text(layout.config_path()).starts_with(kWorkspaceConfigHeader);
}

void expect_nothing_at(const fs::path& path) {
    std::error_code status;
    if (!fs::exists(fs::symlink_status(path, status))) return;
    throw Error(ErrorKind::kBadInput, "E-WORKSPACE-FOREIGN",
                path.string() + ": would be replaced, and was not written by lumi",
                "choose another folder with --workspace, or give this one another name");
}

/// By the file that lumi leaves in each; that of the package is up to its writer.
bool is_ours_or_empty(const WorkspaceLayout& layout, const fs::path& folder) {
    if (folder == layout.package_folder()) return true;
    std::error_code status;
    if (fs::is_directory(folder, status) && fs::is_empty(folder, status)) return true;
    return fs::exists(folder / kDoneMarkerName, status) ||
           fs::exists(folder / kEvaluationName, status) || fs::exists(folder / kPlanName, status);
}

/// Somebody's dataset may well have a folder that is called depth, also beside a lock: that of
/// another program, or of a run that ended before it wrote anything.
WorkspaceLayout without_foreign_files(const WorkspaceLayout& layout) {
    const bool is_known = is_workspace(layout);
    for (const fs::path& folder : folders_of(layout)) {
        if (!is_known || !is_ours_or_empty(layout, folder)) expect_nothing_at(folder);
    }
    if (is_known) return layout;
    for (const fs::path& file : files_of(layout)) expect_nothing_at(file);
    return layout;
}

void remove_leftovers(const WorkspaceLayout& layout) {
    for (const fs::path& file : files_of(layout)) remove_unfinished_siblings(file);
    for (const fs::path& folder : folders_of(layout)) clean_up_after_killed_runs(folder);
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
    : WorkspaceLayout(without_foreign_files(layout)), lock_(made(layout.folder())) {
    remove_leftovers(layout);
}

std::filesystem::path folder_around(const std::filesystem::path& package_folder) {
    const auto path = std::filesystem::absolute(package_folder).lexically_normal();
    const bool ends_in_slash = !path.has_filename();
    return ends_in_slash ? path.parent_path().parent_path() : path.parent_path();
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
    if (!fs::is_regular_file(config_path, status)) {
        throw Error(ErrorKind::kBadInput, "E-WORKSPACE-NONE",
                    folder.string() + ": no workspace of lumi (it has no config.toml)",
                    "name the folder that `lumi build` wrote, such as work/NAME");
    }
    return {folder, ConfigSection::from_file(config_path).text("name", "")};
}

}  // namespace lumi
