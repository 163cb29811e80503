#include "pipeline/stress/stress_subject.h"

#include "calib/pictures/image_io.h"
#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "pipeline/evaluate/held_out_photographs.h"
#include "pipeline/protocol/view_subset.h"
#include "pipeline/stages/mesh_stage.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

/// A package has the configuration that it was made with.
CameraMeshOptions mesh_options_of_package(const std::filesystem::path& package) {
    return camera_mesh_options_of(package / "config.toml");
}

}  // namespace

StressSubject subject_of_workspace(const WorkspaceLayout& workspace, int threads) {
    const PosedPhotographs held_out = held_out_photographs(workspace, threads);
    StressSubject subject{.lumigraph = read_package(workspace.package_folder()),
                          .mesh_options = mesh_options_of_package(workspace.package_folder())};
    for (std::size_t i = 0; i < held_out.capture.views.size(); ++i) {
        const View& view = held_out.capture.views[i];
        const Camera& camera = camera_of(held_out.capture, view);
        subject.views.push_back({.name = view.name,
                                 .eye = {camera, view.cam_from_world},
                                 .photograph = read_color_image(held_out.picture_paths[i]),
                                 .falloff = subject.lumigraph.evened_falloff});
    }
    return subject;
}

StressSubject subject_of_package(const std::filesystem::path& package) {
    constexpr std::size_t kEvery = 4;
    Lumigraph whole = read_package(package);
    if (whole.views.size() <= kEvery) {
        throw Error(ErrorKind::kDegenerateCapture, "E-STRESS-FEW",
                    package.string() + ": " + counted(whole.views.size(), "view") +
                        ", too few to leave some out",
                    "stress a package of at least five views, or a workspace with held-out "
                    "photographs");
    }
    StressSubject subject;
    subject.views_are_held_out = false;
    subject.mesh_options = mesh_options_of_package(package);
    std::vector<int> kept;
    for (std::size_t i = 0; i < whole.views.size(); ++i) {
        LumigraphView& view = whole.views[i];
        if (i % kEvery != kEvery / 2) {
            kept.push_back(static_cast<int>(i));
            continue;
        }
        subject.views.push_back({.name = view.name,
                                 .eye = {view.camera, view.cam_from_world},
                                 .photograph = view.photograph});
    }
    subject.lumigraph = only_these_views(whole, kept, subject.mesh_options);
    return subject;
}

}  // namespace lumi
