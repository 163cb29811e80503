#pragma once

#include <Eigen/Core>
#include <vector>

namespace lumi {

/// The weights of view-dependent texture mapping after Debevec, Taylor, Malik (1996) and Debevec,
/// Yu, Borshukov (1998), without the view map of the latter, to compare with: of all cameras the
/// three count that see the middle of a polygon from the directions nearest to the eye's, each by
/// one over the angle, normalised. All rays to a polygon have those of its middle, so that weights
/// jump at its edges; that they also do where another camera becomes the third is of this choice.
/// One weight a camera; they sum to 1.
[[nodiscard]] std::vector<double> view_dependent_weights(
    const std::vector<Eigen::Vector3d>& centres_in_world, const Eigen::Vector3d& eye_in_world,
    const Eigen::Vector3d& middle_in_world);

}  // namespace lumi
