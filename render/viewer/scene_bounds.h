#pragma once

#include <Eigen/Core>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// A ball that holds most of what the photographs show.
struct SceneBounds {
    Eigen::Vector3d centre_in_world = Eigen::Vector3d::Zero();
    double radius = 1.0;  ///< World units, > 0.
};

/// From the depths that the views are sure of: their median place, and the distance from it that
/// nine in ten keep. Without depth: about the mesh's scene centre, half as wide as the cameras
/// stand away.
[[nodiscard]] SceneBounds bounds_of(const Lumigraph& lumigraph);

/// What the middle of the photograph shows; in the plane of the scene centre where depth is not
/// known.
[[nodiscard]] Eigen::Vector3d point_in_the_middle(const Lumigraph& lumigraph,
                                                  const LumigraphView& view);

}  // namespace lumi
