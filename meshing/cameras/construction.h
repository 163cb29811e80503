#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshing/cameras/arrangement.h"
#include "meshing/cameras/scene_centre.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// How a camera mesh of a known arrangement is put together.
struct ConstructionRules {
    Arrangement arrangement;
    bool convex = false;  ///< The paper's convex mesh: cameras within the hull are left out.
    /// What has to lie in the kernel (scene_hull.h); empty when nothing is known of the scene.
    std::vector<Eigen::Vector3d> scene_hull_in_world;
};

/// The mesh over the cameras, star-shaped about `centre`; nothing is repaired yet.
[[nodiscard]] CameraMesh construct(const std::vector<OpticalAxis>& axes,
                                   const Eigen::Vector3d& centre, const ConstructionRules& rules);

/// The same about the centre within `reach` of `start` that gives the scene the most room in the
/// kernel without losing a camera. The search stops at a quarter of the camera distance, which is
/// enough (for thousands of cameras where the scene is inside at all), and is given a fixed amount
/// of work, so that many cameras mean fewer steps.
[[nodiscard]] CameraMesh construct_with_room(const std::vector<OpticalAxis>& axes,
                                             const Eigen::Vector3d& start, double reach,
                                             const ConstructionRules& rules);

/// The least clearance of the scene's hull to the planes of the faces: >= 0 exactly when the scene
/// lies in the kernel. Infinite without faces or scene.
[[nodiscard]] double scene_clearance(const CameraMesh& mesh,
                                     const std::vector<Eigen::Vector3d>& scene_hull_in_world);

/// How many views are vertices of the mesh.
[[nodiscard]] int distinct_views(const CameraMesh& mesh);

}  // namespace lumi
