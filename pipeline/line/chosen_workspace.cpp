#include "pipeline/line/chosen_workspace.h"

#include <optional>

#include "calib/work/config_section.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "pipeline/line/line.h"
#include "pipeline/workspace/stage_outputs.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// What the configuration in the workspace is of: "" where none says, nothing where it cannot be
/// read. A slip in it is no reason not to write it anew.
std::optional<fs::path> capture_before(const WorkspaceLayout& layout) {
    std::error_code status;
    if (!fs::is_regular_file(layout.config_path(), status)) return fs::path();
    try {
        const ConfigSection capture =
            ConfigSection::from_file(layout.config_path()).section("capture");
        const std::string photos = capture.text("photos", "");
        return photos.empty() ? capture.text("video", "") : photos;
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// Copies elsewhere make the same.
bool was_made_of_equal_files(const WorkspaceLayout& layout, const BuildConfig& config,
                             int threads) {
    const fs::path folder = layout.stage_folder("ingest");
    const auto ingest = read_done_marker(folder / kDoneMarkerName);
    if (!ingest) return false;
    try {
        return sha256_of_content(content_of_photographs(config.photographs_or_video, folder,
                                                        config.ingest.other_folders, threads)) ==
               ingest->identity.inputs;
    } catch (const Error&) {
        return false;  // The ingest stage says what is wrong with them.
    }
}

void expect_no_other_capture(const WorkspaceLayout& layout, const BuildConfig& config,
                             const std::string& advice, int threads) {
    // Else nothing there is worth keeping: a refused attempt leaves its configuration and no more.
    if (!has_finished_stage(layout)) return;
    std::error_code status;
    const std::optional<fs::path> before = capture_before(layout);
    const bool says_nothing = before && before->empty();
    if (says_nothing || !fs::exists(config.photographs_or_video, status) ||
        (before && fs::equivalent(*before, config.photographs_or_video, status)) ||
        was_made_of_equal_files(layout, config, threads))
        return;
    throw Error(ErrorKind::kUsage, "E-WORKSPACE-OTHER",
                layout.folder().string() + ": holds what was made of " +
                    (before ? printable(before->string()) : "other photographs"),
                advice +
                    "; where these are the same, moved and changed since, write their new "
                    "place into the table [capture] of " +
                    layout.config_path().string());
}

}  // namespace

WorkspaceLayout layout_for(const fs::path& named_folder, const BuildConfig& config, int threads) {
    if (!named_folder.empty()) {
        const WorkspaceLayout layout(named_folder, config.name);
        expect_no_other_capture(layout, config, "name another folder with --workspace", threads);
        return layout;
    }
    const WorkspaceLayout layout = workspace_of(config);
    if (!config.workspace.empty()) return layout;
    expect_no_other_capture(layout, config,
                            "build in another folder with --workspace, or from a configuration "
                            "with another name = \"...\"",
                            threads);
    return layout;
}

}  // namespace lumi
