#pragma once

#include <Eigen/Core>
#include <vector>

namespace lumi {

/// The weights of the unstructured lumigraph (Buehler et al., SIGGRAPH 2001), to compare with: of
/// all cameras the four with the least penalty count,
///     penalty_i = angle(eye - X, C_i - X) + 0.1 max(0, 1 - |eye - X| / |C_i - X|),
/// each by 1 - penalty_i / (the fourth's), normalised. The second term depends on where along the
/// ray the eye stands. One weight a camera; they sum to 1. Four cameras are needed; with fewer the
/// nearest in angle counts alone.
[[nodiscard]] std::vector<double> unstructured_weights(
    const std::vector<Eigen::Vector3d>& centres_in_world, const Eigen::Vector3d& eye_in_world,
    const Eigen::Vector3d& target_in_world);

}  // namespace lumi
