#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// Flips edges of the mesh (Lawson 1977) where that raises the lesser clearance of the scene to the
/// planes of the two faces, until no flip helps: the first repair of a kernel that the scene
/// reaches out of, for it moves no camera. Edges are flipped where a face leaves the scene less
/// than `enough` room (world units); the mesh stays star-shaped about its centre and its border
/// stays where it is. Every flip raises a minimum and lowers none below it, so they end. Returns
/// how many edges were flipped.
int flip_edges_for_room(CameraMesh& mesh, const std::vector<Eigen::Vector3d>& scene_hull_in_world,
                        double enough);

}  // namespace lumi
