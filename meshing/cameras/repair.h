#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "meshing/cameras/epipole_loss.h"
#include "meshing/cameras/slide.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// What is to be repaired.
struct RepairRules {
    std::vector<Eigen::Vector3d> scene_in_world;  ///< Points, not only their hull.
    std::function<Eigen::Vector3d(int view_index)> centre_of_view;  ///< Where it was taken from.
};

/// What the repairs of a mesh came to.
struct RepairReport {
    int edges_flipped = 0;
    SlideReport slide;
    EpipoleLoss epipole_loss;  ///< The price of the slide.
};

/// Brings the scene into the kernel where it reaches out: flips edges, then slides vertices, as far
/// as that takes. Rays that cross one face exactly come before cameras that keep all of their own
/// rays: the former make the picture jump, the latter only blend a little more. When no slide that
/// `SlideOptions` allow brings the whole scene in, the largest of a few inner parts that can be had
/// (the points nearest to their median); when none can, the mesh stays as the flips left it.
[[nodiscard]] RepairReport repair_kernel(CameraMesh& mesh, const RepairRules& rules);

}  // namespace lumi
