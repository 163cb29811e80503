#include "meshing/cameras/preconditions.h"

#include <algorithm>

#include "calib/work/formatted.h"

namespace lumi {
namespace {

/// Captures that walk around something were seen at 0.98 and more; those that failed by this, at
/// 0.55 and less.
constexpr double kLeastSceneShare = 0.75;
/// And with 0.75 of the cameras and more; those that failed by this, with 0.52 and less.
constexpr double kLeastCameraShare = 0.6;

}  // namespace

double share_that_faces(const Capture& capture, const std::vector<OpticalAxis>& axes,
                        const Eigen::Vector3d& centre_in_world, bool inside_out) {
    const auto facing = std::count_if(axes.begin(), axes.end(), [&](const OpticalAxis& axis) {
        const View& view = capture.views[static_cast<std::size_t>(axis.view_index)];
        const Camera& camera = camera_of(capture, view);
        const Eigen::Vector3d faced =
            inside_out ? Eigen::Vector3d(2 * axis.centre_in_world - centre_in_world)
                       : centre_in_world;
        const auto pixel = project(camera, view.cam_from_world * faced);
        return pixel && is_inside(camera, *pixel);
    });
    return static_cast<double>(facing) / static_cast<double>(axes.size());
}

std::optional<std::string> why_no_surface(const SurfacePreconditions& preconditions) {
    if (preconditions.share_that_faces_scene < kLeastCameraShare) {
        return formatted(
            "only %.0f %% of the cameras face what a surface through them would lie around",
            100 * preconditions.share_that_faces_scene);
    }
    if (preconditions.scene_share_in_kernel < kLeastSceneShare) {
        return formatted(
            "rays to %.0f %% of the scene's points cross two faces of a mesh over the cameras",
            100 * (1 - preconditions.scene_share_in_kernel));
    }
    return std::nullopt;
}

}  // namespace lumi
