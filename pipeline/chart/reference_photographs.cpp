#include "pipeline/chart/reference_photographs.h"

#include <map>

#include "calib/capture/colmap_model.h"
#include "calib/capture/undistortion.h"
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
        view.camera_index = static_cast<int>(held_out.cameras.size());
        held_out.cameras.push_back(resized(lens, copy->second->width_px, copy->second->height_px));
        paths.push_back(copy->second->picture_path);
    }
    return undistort(held_out, paths, scratch_folder, threads, progress);
}

}  // namespace lumi
