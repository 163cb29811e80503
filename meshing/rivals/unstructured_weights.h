#pragma once

#include <Eigen/Core>
#include <vector>

namespace lumi {

/// The weights of the unstructured lumigraph (Buehler et al., SIGGRAPH 2001), to compare with: of
/// all cameras the four with the least penalty count,
///     penalty_i = (angle(eye - X, C_i - X) + 0.1 max(0, 1 - |eye - X| / |C_i - X|)) / share_i,
/// each by 1 - penalty_i / threshold, normalised, where the threshold lies just beyond the fourth's
/// penalty, so that cameras come and go without a jump. Fewer are all far within the threshold, and
/// count alike. A camera without penalty, where the eye stands or on the ray, counts alone: that is
/// what the paper calls epipole consistency. The other usual form, (1 - penalty_i / threshold) /
/// penalty_i, comes to it steadily, and does not even the others out where the fourth is near its
/// border, but pictures of the benchmark's scenes are less like the truth by it: of what is covered
/// by 0.1 to 0.2 dB, as four photographs even out more than one. Where depth is estimated they are
/// as good or 0.1 dB better by it. The second term depends on where along the ray the eye stands.
///
/// `in_view_shares` are the paper's penalty for the field of view: 1 well inside a photograph and
/// 0 at its border, where the penalty is infinite; > 0. Empty: all are 1. One weight a camera, of
/// at least one; they sum to 1.
[[nodiscard]] std::vector<double> unstructured_weights(
    const std::vector<Eigen::Vector3d>& centres_in_world, const Eigen::Vector3d& eye_in_world,
    const Eigen::Vector3d& target_in_world, const std::vector<double>& in_view_shares = {});

}  // namespace lumi
