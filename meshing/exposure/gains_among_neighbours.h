#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace lumi {

/// The gains that bring each photograph into the mean exposure of those around it instead of all
/// (exposure_gains.h): each over the geometric mean of its own and those of the four nearest
/// cameras. A picture is drawn from photographs that stand side by side, so that what differs
/// between them shows; what changes slowly along a capture, as exposure control has it, does not,
/// and stays as it was taken. None exceeds four stops.
///
/// A photograph that does not tell white balance (ExposureGains::tell_white_balance) keeps one gain
/// for all channels, and moves that of others in all alike.
[[nodiscard]] std::vector<std::array<double, 3>> gains_among_neighbours(
    const std::vector<std::array<double, 3>>& gains, const std::vector<char>& tell_white_balance,
    const std::vector<Eigen::Vector3d>& centres_in_world);

}  // namespace lumi
