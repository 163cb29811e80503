#include "pipeline/workspace/workspace.h"

#include <vector>

#include "calib/work/config_section.h"
#include "calib/work/error.h"
#include "calib/work/whole_folder.h"

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

/// Temporary siblings of files that are written whole: the name, a dot and more.
void remove_unfinished_files(const WorkspaceLayout& layout) {
    std::vector<fs::path> unfinished;
    for (const fs::path& target :
         {layout.config_path(), layout.stages_path(), layout.report_path()}) {
        const std::string prefix = target.filename().string() + ".";
        for (const fs::directory_entry& entry : fs::directory_iterator(layout.folder())) {
            if (entry.path().filename().string().starts_with(prefix)) {
                unfinished.push_back(entry.path());
            }
        }
    }
    for (const fs::path& path : unfinished) fs::remove(path);
}

void remove_leftovers(const WorkspaceLayout& layout) {
    remove_unfinished_files(layout);
    for (const char* stage : {"ingest", "poses", "mesh", "depth", "pack"}) {
        clean_up_after_killed_runs(layout.stage_folder(stage));
    }
    clean_up_after_killed_runs(layout.evaluation_folder());
    clean_up_after_killed_runs(layout.package_folder());
}

}  // namespace

Workspace::Workspace(const WorkspaceLayout& layout)
    : WorkspaceLayout(layout), lock_(made(layout.folder())) {
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
    if (!fs::is_regular_file(config_path, status)) {
        throw Error(ErrorKind::kBadInput, "E-WORKSPACE-NONE",
                    folder.string() + ": no workspace of lumi (it has no config.toml)",
                    "name the folder that `lumi build` wrote, such as work/NAME");
    }
    return {folder, ConfigSection::from_file(config_path).text("name", "")};
}

}  // namespace lumi
