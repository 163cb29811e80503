#include "pipeline/evaluate/held_out_photographs.h"

#include "calib/work/error.h"
#include "pipeline/evaluate/stale_package.h"
#include "pipeline/stages/posed_files.h"
#include "pipeline/stages/used_views.h"
#include "render/lumigraph/manifest.h"

namespace lumi {

namespace fs = std::filesystem;

PackRecord finished_pack(const WorkspaceLayout& workspace) {
    const fs::path pack_folder = workspace.stage_folder("pack");
    std::error_code status;
    // A workspace that was given another name has its package under the one before.
    if (!fs::is_directory(pack_folder, status) ||
        !fs::is_regular_file(workspace.package_folder() / kManifestName, status)) {
        throw Error(ErrorKind::kBadInput, "E-EVAL-NOPACKAGE",
                    workspace.folder().string() + ": no finished package",
                    "run `lumi build CONFIG.toml` first");
    }
    PackRecord record = read_pack_record(pack_folder);
    if (record.held_out.empty()) {
        throw Error(ErrorKind::kUsage, "E-EVAL-NOHOLDOUT",
                    workspace.folder().string() + ": no photograph was held out",
                    "set hold_out_every = 8, or hold_out = [\"name.jpg\"], under [evaluate] in the "
                    "configuration (a folder of photographs has its own in the workspace, "
                    "config.toml), and build from that");
    }
    return record;
}

PosedPhotographs packed_photographs(const WorkspaceLayout& workspace, const PackRecord& record,
                                    int threads) {
    const std::string reason = why_package_is_stale(workspace, record, threads);
    if (!reason.empty()) {
        throw Error(ErrorKind::kBadInput, "E-EVAL-STALE",
                    workspace.folder().string() + ": " + reason,
                    "run `lumi build CONFIG.toml` again");
    }
    return read_posed_photographs(workspace.stage_folder("poses") / "pinhole");
}

PosedPhotographs held_out_photographs(const WorkspaceLayout& workspace, const PackRecord& record,
                                      int threads) {
    PosedPhotographs held_out =
        only_views(packed_photographs(workspace, record, threads), record.held_out);
    if (held_out.capture.views.empty()) {
        throw Error(ErrorKind::kDegenerateCapture, "E-EVAL-NOPOSE",
                    workspace.folder().string() + ": no held-out photograph has a pose",
                    "hold out photographs that are registered; report.html lists them");
    }
    return held_out;
}

PosedPhotographs held_out_photographs(const WorkspaceLayout& workspace, int threads) {
    return held_out_photographs(workspace, finished_pack(workspace), threads);
}

}  // namespace lumi
