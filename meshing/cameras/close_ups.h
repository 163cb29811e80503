#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/capture/capture.h"
#include "meshing/cameras/scene_centre.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// Close-ups that look at one part of the scene from nearby directions, and how close: on them a
/// pixel is `2^level` to `2^(level + 1)` times finer on the scene than usual.
struct CloseUpGroup {
    int level = 1;
    std::vector<int> axes;  ///< Indices into the optical axes that were given, ascending.
};

/// The close-ups among the views: those whose pixels are at least twice as fine on the scene as the
/// median view's and that see at most four fifths as much of it (a finer photograph of the whole
/// scene is no close-up: the camera mesh holds it like any other). In groups, coarse before fine:
/// each group looks at an overlapping part of the scene from within 60 degrees of its first view.
/// None when fewer than three views, or less than half of them, would be left.
[[nodiscard]] std::vector<CloseUpGroup> find_close_ups(
    const Capture& capture, const std::vector<OpticalAxis>& axes,
    const std::vector<Eigen::Vector3d>& scene_in_world);

/// The shell of a group: the camera mesh over its cameras alone about the point that they look at,
/// with a ring of virtual vertices 35 degrees around them. Its weights refine those of the mesh
/// that it belongs to: they count fully at its cameras and nothing at the ring (see
/// `capture_fade`), so that no seam shows where it ends.
[[nodiscard]] CameraMesh close_up_shell(const std::vector<OpticalAxis>& group_axes,
                                        const std::vector<Eigen::Vector3d>& seen_in_world);

/// The scene points that lie in the photograph of at least one of the group's views.
[[nodiscard]] std::vector<Eigen::Vector3d> points_in_view(
    const Capture& capture, const std::vector<OpticalAxis>& group_axes,
    const std::vector<Eigen::Vector3d>& scene_in_world);

}  // namespace lumi
