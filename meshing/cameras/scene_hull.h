#pragma once

#include <Eigen/Core>
#include <vector>

namespace lumi {

/// What the camera mesh has to stand around, reduced to the points that decide: the corners of the
/// convex hull of the scene's points (world). Outliers, which lie farther from the median of the
/// points than 1.3 times nine tenths of them do, are left out, and so is the share
/// `1 - kept_share` that lies farthest. A half-space contains the kept points exactly when it
/// contains these. All kept points when they lie in one plane; none when there are none.
[[nodiscard]] std::vector<Eigen::Vector3d> scene_hull(const std::vector<Eigen::Vector3d>& points,
                                                      double kept_share);

}  // namespace lumi
