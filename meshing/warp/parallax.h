#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace lumi {

/// A view that stands hardly aside of another, as in a burst or where a film paused, sees the same
/// of it at any depth: it agrees with whatever is said, and is no witness. Whether it stands aside
/// is told by the other views around: what has less than this share of the parallax of the fastest
/// of them has none.
inline constexpr double kLeastParallaxShare = 0.05;

/// Places in the list of those that have parallax, given each view's (disparity, or distance in
/// space): the first `most` at most.
[[nodiscard]] std::vector<std::size_t> with_parallax(const std::vector<double>& parallaxes,
                                                     std::size_t most);

/// How far the nearest other camera stands from each, whether it has parallax or not; infinite for
/// a lone one.
[[nodiscard]] std::vector<double> nearest_distances(const std::vector<Eigen::Vector3d>& centres);

/// How far the nearest of other cameras that has parallax stands from `centre`; 0 where none does.
/// A camera in the same place is no other one.
[[nodiscard]] double nearest_baseline(const Eigen::Vector3d& centre,
                                      const std::vector<Eigen::Vector3d>& centres);

/// The median of these over all cameras, without those that have none; 0 where none has one.
[[nodiscard]] double typical_baseline(const std::vector<Eigen::Vector3d>& centres);

}  // namespace lumi
