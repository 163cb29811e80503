#include "pipeline/evaluate/evaluate_workspace.h"

#include <map>
#include <nlohmann/json.hpp>

#include "calib/capture/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_folder.h"
#include "pipeline/evaluate/comparison_strip.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/stages/file_stems.h"
#include "pipeline/stages/pack_stage.h"
#include "pipeline/stages/posed_files.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/workspace/content.h"
#include "pipeline/workspace/json_file.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

PackRecord finished_pack(const Workspace& workspace) {
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

PosedPhotographs held_out_photographs(const Workspace& workspace, const PackRecord& record,
                                      int threads) {
    const fs::path pinhole_folder = workspace.stage_folder("poses") / "pinhole";
    std::vector<ContentEntry> content = content_of(pinhole_folder, threads);
    for (ContentEntry& entry : content) entry.name = "poses/pinhole/" + entry.name;
    if (sha256_of_content(content) != record.poses_sha256) {
        throw Error(ErrorKind::kBadInput, "E-EVAL-STALE",
                    workspace.folder().string() + ": the package was made from other poses",
                    "run `lumi build CONFIG.toml` again");
    }
    PosedPhotographs held_out = only_views(read_posed_photographs(pinhole_folder), record.held_out);
    if (held_out.capture.views.empty()) {
        throw Error(ErrorKind::kDegenerateCapture, "E-EVAL-NOPOSE",
                    workspace.folder().string() + ": no held-out photograph has a pose",
                    "hold out photographs that are registered; report.html lists them");
    }
    return held_out;
}

/// NAME.png for the mode that stands first, NAME.MODE.png for the others.
std::string strip_name(const std::string& stem, RenderMode mode, RenderMode first_mode) {
    return mode == first_mode ? stem + ".png" : stem + '.' + name_of(mode) + ".png";
}

}  // namespace

Evaluation evaluate_workspace(const Workspace& workspace, const std::vector<RenderMode>& modes,
                              int threads, Progress& progress) {
    const PackRecord record = finished_pack(workspace);
    const PosedPhotographs held_out = held_out_photographs(workspace, record, threads);
    const Lumigraph lumigraph = read_package(workspace.package_folder());

    const std::vector<std::string> names = view_names(held_out.capture);
    const std::vector<std::string> stems = file_stems_of_views(names);
    std::map<std::string, std::string> stem_of;
    for (std::size_t i = 0; i < names.size(); ++i) stem_of[names[i]] = stems[i];

    WholeFolder folder(workspace.evaluation_folder());
    const auto write_strip = [&](RenderMode mode, const JudgedView& view) {
        const std::string& stem = stem_of.at(view.score.name);
        write_png(folder.staging() / strip_name(stem, mode, modes.front()),
                  comparison_strip(view.photograph, view.rendering.color, view.rendering.coverage));
    };
    Evaluation evaluation = evaluate_held_out(lumigraph, held_out, modes, write_strip, progress);

    nlohmann::ordered_json json = evaluation_json(evaluation);
    json["package_sha256"] = package_sha256(workspace);
    for (auto& view : json["views"]) {
        view["picture"] = stem_of.at(view["name"].get<std::string>()) + ".png";
    }
    write_json_file(folder.staging() / "evaluation.json", json);
    folder.put_in_place();
    return evaluation;
}

}  // namespace lumi
