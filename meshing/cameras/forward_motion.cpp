#include "meshing/cameras/forward_motion.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "calib/capture/degrees.h"

namespace lumi {
namespace {

/// Walks that sway twice as much are shown better without faces, too, but a wall of photographs
/// with close-ups of it looks like one (README.images/measurements.md, Camera mesh).
constexpr double kMostSwayShare = 0.2;
/// Past what they look at by more, faces between the cameras are as good.
constexpr double kMostAngle_deg = 30.0;
/// Length of the mean of all lines of sight, from which on they are one.
constexpr double kLeastAgreement = 0.85;

/// Not of length one: shorter the more the cameras look in different directions.
Eigen::Vector3d mean_line_of_sight(const std::vector<OpticalAxis>& axes) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const OpticalAxis& axis : axes) sum += axis.direction_in_world;
    return sum / static_cast<double>(axes.size());
}

Eigen::Matrix3d moments_of_places(const std::vector<OpticalAxis>& axes) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const OpticalAxis& axis : axes) middle += axis.centre_in_world;
    middle /= static_cast<double>(axes.size());
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const OpticalAxis& axis : axes) {
        const Eigen::Vector3d from_middle = axis.centre_in_world - middle;
        moments += from_middle * from_middle.transpose();
    }
    return moments;
}

}  // namespace

std::optional<ForwardMotion> forward_motion(const std::vector<OpticalAxis>& axes) {
    if (axes.size() < 2) return std::nullopt;
    const Eigen::Vector3d sight = mean_line_of_sight(axes);
    if (sight.norm() < kLeastAgreement) return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments_of_places(axes));
    const Eigen::Vector3d sigmas = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    if (!(sigmas[2] > 0)) return std::nullopt;
    const double cosine = std::abs(solver.eigenvectors().col(2).dot(sight.normalized()));
    const ForwardMotion motion{sigmas[1] / sigmas[2],
                               std::acos(std::min(1.0, cosine)) / kRadiansPerDegree};
    if (motion.sway_share > kMostSwayShare || motion.angle_deg > kMostAngle_deg)
        return std::nullopt;
    return motion;
}

}  // namespace lumi
