#include "meshing/rivals/unstructured_weights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace lumi {
namespace {

constexpr std::size_t kCameras = 4;
constexpr double kResolutionPenalty = 0.1;
/// With no more penalty a camera is where the eye is, or on its ray.
constexpr double kNoPenalty = 1e-9;
/// The threshold is so much greater than the fourth penalty: four alike count alike.
constexpr double kBeyondFourth = 1e-6;

double penalty_of(const Eigen::Vector3d& to_eye, const Eigen::Vector3d& to_camera) {
    const double angle = std::atan2(to_eye.cross(to_camera).norm(), to_eye.dot(to_camera));
    return angle + kResolutionPenalty * std::max(0.0, 1.0 - to_eye.norm() / to_camera.norm());
}

}  // namespace

std::vector<double> unstructured_weights(const std::vector<Eigen::Vector3d>& centres_in_world,
                                         const Eigen::Vector3d& eye_in_world,
                                         const Eigen::Vector3d& target_in_world,
                                         const std::vector<double>& in_view_shares) {
    std::vector<double> penalties;
    for (std::size_t i = 0; i < centres_in_world.size(); ++i) {
        const double share = in_view_shares.empty() ? 1.0 : in_view_shares[i];
        penalties.push_back(
            penalty_of(eye_in_world - target_in_world, centres_in_world[i] - target_in_world) /
            share);
    }
    std::vector<std::size_t> order(penalties.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto count = static_cast<std::ptrdiff_t>(std::min(kCameras, order.size()));
    std::partial_sort(order.begin(), order.begin() + count, order.end(),
                      [&](std::size_t a, std::size_t b) { return penalties[a] < penalties[b]; });
    order.resize(static_cast<std::size_t>(count));
    std::vector<double> weights(penalties.size(), 0.0);
    if (penalties[order.front()] <= kNoPenalty) {
        weights[order.front()] = 1.0;
        return weights;
    }
    const double threshold_inverse =
        order.size() < kCameras ? 0.0 : 1 / ((1 + kBeyondFourth) * penalties[order.back()]);
    double sum = 0;
    for (const std::size_t camera : order) {
        weights[camera] = 1 - penalties[camera] * threshold_inverse;
        sum += weights[camera];
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

}  // namespace lumi
