#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "calib/capture/all_views.h"
#include "calib/capture/capture.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

using Points = std::vector<Eigen::Vector3d>;

/// Pinhole cameras at `centres` that look at `target` (a camera on the target looks along +z), and
/// points that every camera has in its track.
[[nodiscard]] Capture capture_of(const Points& centres, const Eigen::Vector3d& target,
                                 const Points& points);

[[nodiscard]] Eigen::Vector3d random_direction(std::mt19937& random);
[[nodiscard]] Points points_in_ball(int count, const Eigen::Vector3d& centre, double radius,
                                    std::mt19937& random);

/// Nearly uniform directions (Fibonacci), those with z >= `least_z` only.
[[nodiscard]] Points sphere_directions(int count, double least_z);

/// Faces that the line enters through, by brute force.
[[nodiscard]] int entering_faces(const CameraMesh& mesh, const Eigen::Vector3d& point,
                                 const Eigen::Vector3d& direction);

/// Sum of the weights per view.
[[nodiscard]] std::vector<double> weights_by_view(const RayWeights& weights, std::size_t views);

}  // namespace lumi
