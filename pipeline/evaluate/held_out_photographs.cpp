#include "pipeline/evaluate/held_out_photographs.h"

#include "calib/work/error.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/stages/posed_files.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/workspace/content.h"
#include "pipeline/workspace/stage_outputs.h"

namespace lumi {

namespace fs = std::filesystem;

PackRecord finished_pack(const WorkspaceLayout& workspace) {
    const fs::path pack_folder = workspace.stage_folder("pack");
    std::error_code status;
    if (!fs::is_directory(pack_folder, status)) {
        throw Error(ErrorKind::kBadInput, "E-EVAL-NOPACKAGE",
                    workspace.folder().string() + ": no finished package",
                    "run `lumi build CONFIG.toml` first");
    }
    PackRecord record = read_pack_record(pack_folder);
    if (record.held_out.empty()) {
        throw Error(ErrorKind::kUsage, "E-EVAL-NOHOLDOUT",
                    workspace.folder().string() + ": no photograph was held out",
                    "set hold_out_every = 8, or hold_out = [\"name.jpg\"], under [evaluate] in the "
                    "configuration, and build again");
    }
    return record;
}

namespace {

/// What the package's record holds, if nothing changed since. Working copies, too: they bear
/// numbers, which move where a photograph goes or comes.
std::string pictures_sha256(const WorkspaceLayout& workspace, int threads) {
    std::vector<ContentEntry> all;
    for (const char* folder : {"ingest", "poses/pinhole"}) {
        for (ContentEntry& entry : content_of(workspace.folder() / folder, threads)) {
            if (entry.name != kDoneMarkerName)
                all.push_back({std::string(folder) + '/' + entry.name, std::move(entry.sha256)});
        }
    }
    return sha256_of_content(all);
}

}  // namespace

PosedPhotographs packed_photographs(const WorkspaceLayout& workspace, const PackRecord& record,
                                    int threads) {
    const auto refuse = [&](const char* reason) {
        throw Error(ErrorKind::kBadInput, "E-EVAL-STALE", workspace.folder().string() + reason,
                    "run `lumi build CONFIG.toml` again");
    };
    if (package_sha256(workspace) != record.package_sha256)
        refuse(": the package is not the one that was recorded, as by a run that did not end");
    if (pictures_sha256(workspace, threads) != record.pictures_sha256)
        refuse(": the package was made from other photographs or poses");
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
