#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "meshing/cameras/slide.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// What is to be repaired, and how far.
struct RepairRules {
    std::vector<Eigen::Vector3d> scene_in_world;  ///< Points, not only their hull.
    std::function<Eigen::Vector3d(int view_index)> centre_of_view;  ///< Where it was taken from.
    /// A slide that takes more of its own weight from any camera on its own rays is not made.
    double most_epipole_loss = 0.25;
};

/// What the repairs of a mesh came to.
struct RepairReport {
    int edges_flipped = 0;
    SlideReport slide;
    double worst_epipole_loss = 0.0;
};

/// Brings the scene into the kernel where it reaches out: flips edges, then slides vertices. When
/// the whole scene cannot be had at that price, the largest of a few inner parts that can (the
/// points nearest to their median); when none can, the mesh stays as the flips left it.
[[nodiscard]] RepairReport repair_kernel(CameraMesh& mesh, const RepairRules& rules);

}  // namespace lumi
