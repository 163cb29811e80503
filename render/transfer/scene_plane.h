#pragma once

#include <Eigen/Core>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The plane that stands for the scene when no depth is used: through the scene's centre and facing
/// the eye's position, so that turning the eye turns the picture and nothing swims. It turns as the
/// eye moves: a ray through the centre meets it at the same point from wherever on it the eye
/// stands, others at another, so that they are not looked up alike by every eye as in the paper,
/// whose cameras have fixed planes (focal_plane.h has such a one). As a line: the
/// eye's inverse depth at pixel (x, y) is max(0, line . (x, y, 1)); away from the plane it is
/// infinitely far. An eye that comes closer than the scene's near end stays that far from the
/// plane; where it passes the centre the plane recedes to infinity, as it turns about there.
[[nodiscard]] Eigen::Vector3d scene_plane_inverse_depth(const Lumigraph& lumigraph, const Eye& eye);

}  // namespace lumi
