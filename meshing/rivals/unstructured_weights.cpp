#include "meshing/rivals/unstructured_weights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace lumi {
namespace {

constexpr std::size_t kCameras = 4;
constexpr double kResolutionPenalty = 0.1;

double penalty_of(const Eigen::Vector3d& to_eye, const Eigen::Vector3d& to_camera) {
    const double angle = std::atan2(to_eye.cross(to_camera).norm(), to_eye.dot(to_camera));
    return angle + kResolutionPenalty * std::max(0.0, 1.0 - to_eye.norm() / to_camera.norm());
}

}  // namespace

std::vector<double> unstructured_weights(const std::vector<Eigen::Vector3d>& centres_in_world,
                                         const Eigen::Vector3d& eye_in_world,
                                         const Eigen::Vector3d& target_in_world) {
    std::vector<double> penalties;
    for (const Eigen::Vector3d& centre : centres_in_world) {
        penalties.push_back(penalty_of(eye_in_world - target_in_world, centre - target_in_world));
    }
    std::vector<std::size_t> order(penalties.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto count = static_cast<std::ptrdiff_t>(std::min(kCameras, order.size()));
    std::partial_sort(order.begin(), order.begin() + count, order.end(),
                      [&](std::size_t a, std::size_t b) { return penalties[a] < penalties[b]; });
    std::vector<double> weights(penalties.size(), 0.0);
    double sum = 0;
    const double threshold = penalties[order[static_cast<std::size_t>(count - 1)]];
    for (std::ptrdiff_t i = 0; i < count && order.size() >= kCameras && threshold > 0; ++i) {
        const std::size_t camera = order[static_cast<std::size_t>(i)];
        weights[camera] = 1.0 - penalties[camera] / threshold;
        sum += weights[camera];
    }
    if (!(sum > 0)) {
        weights[order.front()] = 1.0;
        return weights;
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

}  // namespace lumi
