#pragma once

#include <Eigen/Core>
#include <vector>

namespace lumi {

/// A camera that a ray passes, and what its photograph shows of the ray's point.
struct PassedCamera {
    double from_ray = 0.0;  ///< Distance of its centre, in world units.
    double share = 1.0;     ///< How much it counts at all, above 0 and up to 1.
    int view_index = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// Its share on the ray, falling linearly to 0 at `radius` from it. On the ray it is the share
/// whatever the radius, and where that is infinite it is so everywhere.
[[nodiscard]] double cone_weight(const PassedCamera& camera, double radius);

/// The least radius at which the weights of these cameras, of which none is nearer to the ray than
/// the one before, sum to 1; infinite where their shares sum to no more. Of two cameras it is the
/// one with which their weights are linear between them, and a camera on the ray leaves the others
/// none. It changes without a jump as shares fade, so that cameras with a share of 0 may be left
/// out.
[[nodiscard]] double least_cone_radius(const std::vector<PassedCamera>& by_distance);

}  // namespace lumi
