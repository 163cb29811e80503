#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/capture/capture.h"

namespace lumi {

/// A camera as the mesh construction sees it: where it stands relative to the scene centre.
struct CameraDirection {
    int view_index = 0;
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< From the scene centre, length one.
    double radius = 1.0;                                   ///< Distance from the scene centre.
};

/// Positions of the cameras about `centre`. Directions that coincide would lose a camera in any
/// triangulation of the sphere; each further one is turned aside by a hundredth of the median
/// spacing, so that every camera stays a vertex.
[[nodiscard]] std::vector<CameraDirection> camera_directions(const Capture& capture,
                                                             const std::vector<int>& view_indices,
                                                             const Eigen::Vector3d& centre);

/// Any unit vector orthogonal to `axis`; the same one each time.
[[nodiscard]] Eigen::Vector3d orthogonal_unit(const Eigen::Vector3d& axis);

}  // namespace lumi
