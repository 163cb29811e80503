#include "meshing/rivals/view_dependent_weights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace lumi {
namespace {

constexpr std::size_t kBlendedCameras = 3;
constexpr double kLeastAngle_rad = 1e-4;

}  // namespace

std::vector<double> view_dependent_weights(const std::vector<Eigen::Vector3d>& centres_in_world,
                                           const Eigen::Vector3d& eye_in_world,
                                           const Eigen::Vector3d& middle_in_world) {
    const Eigen::Vector3d to_eye = eye_in_world - middle_in_world;
    std::vector<double> closeness;
    for (const Eigen::Vector3d& centre : centres_in_world) {
        const Eigen::Vector3d to_camera = centre - middle_in_world;
        const double angle = std::atan2(to_eye.cross(to_camera).norm(), to_eye.dot(to_camera));
        closeness.push_back(1 / std::max(angle, kLeastAngle_rad));
    }
    std::vector<std::size_t> order(closeness.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto count = static_cast<std::ptrdiff_t>(std::min(kBlendedCameras, order.size()));
    std::partial_sort(order.begin(), order.begin() + count, order.end(),
                      [&](std::size_t a, std::size_t b) { return closeness[a] > closeness[b]; });
    order.resize(static_cast<std::size_t>(count));
    double sum = 0;
    for (const std::size_t camera : order) sum += closeness[camera];
    std::vector<double> weights(closeness.size(), 0.0);
    for (const std::size_t camera : order) weights[camera] = closeness[camera] / sum;
    return weights;
}

}  // namespace lumi
