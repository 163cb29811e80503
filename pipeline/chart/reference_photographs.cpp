#include "pipeline/chart/reference_photographs.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/undistortion.h"
#include "calib/work/error.h"
#include "pipeline/stages/pack_stage.h"
#include "pipeline/stages/used_views.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

Error nothing_to_measure(const WorkspaceLayout& workspace, const std::string& what) {
    return {ErrorKind::kDegenerateCapture, "E-EVAL-NOPOSE",
            workspace.folder().string() + ": " + what,
            "hold out photographs that are registered; report.html lists them"};
}

/// Bars that were cut off at another width end at other rows.
void require_same_shape(const Camera& lens, const Photograph& reference) {
    const double scale = static_cast<double>(reference.width_px) / lens.width_px;
    const double off_px = std::abs(scale * lens.height_px - reference.height_px);
    if (off_px <= std::max(1.0, scale)) return;
    throw Error(ErrorKind::kBadInput, "E-CHART-SHAPE",
                reference.name + ": bars were cut off unlike at " + std::to_string(lens.width_px) +
                    " and " + std::to_string(reference.width_px) + " pixels of width",
                "cut them off the photographs first, or leave them in: [capture] keep_overlays = "
                "true");
}

}  // namespace

PosedPhotographs reference_photographs(const WorkspaceLayout& workspace,
                                       const std::vector<Photograph>& reference_copies,
                                       const fs::path& scratch_folder, int threads,
                                       Progress& progress) {
    const PackRecord record = read_pack_record(workspace.stage_folder("pack"));
    if (record.held_out.empty()) {
        throw Error(ErrorKind::kUsage, "E-EVAL-NOHOLDOUT",
                    workspace.folder().string() + ": no photograph was held out",
                    "set hold_out_every = 8 under [evaluate] in the configuration");
    }
    std::map<std::string, const Photograph*> copy_of;
    for (const Photograph& copy : reference_copies) copy_of[copy.name] = &copy;

    PosedPhotographs model;
    model.capture = read_colmap_model(workspace.stage_folder("poses") / "sparse");
    model.picture_paths.resize(model.capture.views.size());
    Capture held_out = only_views(model, record.held_out).capture;
    if (held_out.views.empty()) throw nothing_to_measure(workspace, "no held-out view has a pose");
    held_out.points.clear();
    const std::vector<Camera> lenses = held_out.cameras;
    held_out.cameras.clear();
    std::vector<fs::path> paths;
    for (View& view : held_out.views) {
        const auto copy = copy_of.find(view.name);
        if (copy == copy_of.end()) {
            throw nothing_to_measure(workspace, view.name + " has no working copy to compare with");
        }
        const Camera& lens = lenses[static_cast<std::size_t>(view.camera_index)];
        require_same_shape(lens, *copy->second);
        view.camera_index = static_cast<int>(held_out.cameras.size());
        held_out.cameras.push_back(resized(lens, copy->second->width_px, copy->second->height_px));
        paths.push_back(copy->second->picture_path);
    }
    return undistort(held_out, paths, scratch_folder, threads, progress);
}

}  // namespace lumi
