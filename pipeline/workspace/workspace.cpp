#include "pipeline/workspace/workspace.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "calib/work/config_section.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "pipeline/workspace/json_file.h"
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

/// A folder of the workspace, and the file that lumi leaves in it.
struct MarkedFolder {
    fs::path path;
    const char* marker;
};

/// All but the package, whose writer tells for itself what it replaces.
std::vector<MarkedFolder> marked_folders_of(const WorkspaceLayout& layout) {
    std::vector<MarkedFolder> folders{{layout.evaluation_folder(), kEvaluationName},
                                      {layout.stage_folder("plan"), kPlanName}};
    for (const char* stage : {"ingest", "calibrate", "poses", "mesh", "depth", "pack"})
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

/// The stages of the last run; none where its file does not tell.
std::vector<std::string> listed_stages(const WorkspaceLayout& layout) {
    try {
        const auto run = read_json_file(layout.stages_path());
        std::vector<std::string> names;
        for (const auto& stage : run.at("stages")) names.push_back(stage.at("name"));
        return names;
    } catch (const Error&) {
        return {};
    } catch (const nlohmann::json::exception&) {
        return {};
    }
}

void expect_nothing_at(const fs::path& path) {
    std::error_code status;
    if (!fs::exists(fs::symlink_status(path, status))) return;
    throw Error(ErrorKind::kBadInput, "E-WORKSPACE-FOREIGN",
                path.string() + ": would be replaced, and nothing tells that lumi wrote it",
                "choose another folder with --workspace, or give this one another name; or remove "
                "it, if an earlier run of lumi left it");
}

bool has_marker_or_nothing(const MarkedFolder& folder) {
    std::error_code status;
    if (fs::is_directory(folder.path, status) && fs::is_empty(folder.path, status)) return true;
    return fs::is_regular_file(folder.path / folder.marker, status);
}

/// Somebody's dataset may well have a folder that is called depth and a file config.toml, also
/// beside a lock: that of another program, or of a run that ended before it wrote anything. Where
/// the configuration is lumi's own, so is a stage that it says it has run: whoever wants it to run
/// again removes its marker.
WorkspaceLayout without_foreign_files(const WorkspaceLayout& layout) {
    const bool is_workspace = has_own_configuration(layout);
    const bool may_hold_ours = is_workspace || has_lock(layout);
    if (!may_hold_ours) expect_nothing_at(layout.package_folder());
    const std::vector<std::string> listed =
        is_workspace ? listed_stages(layout) : std::vector<std::string>{};
    for (const MarkedFolder& folder : marked_folders_of(layout)) {
        const bool is_listed =
            std::find(listed.begin(), listed.end(), folder.path.filename()) != listed.end();
        const bool is_ours = is_listed || (may_hold_ours && has_marker_or_nothing(folder));
        if (!is_ours) expect_nothing_at(folder.path);
    }
    if (is_workspace) return layout;
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
