#include "meshing/depth_models/plane_depth.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "calib/work/median.h"

namespace lumi {
namespace {

/// A model of the scene, not a measurement of the pixel.
constexpr std::uint8_t kModelled = 64;

double middle_inverse_depth(const DepthView& view) {
    if (view.points.empty()) return 0.5 * (view.range.far + view.range.near);
    std::vector<double> values;
    for (const SparsePoint& point : view.points) values.push_back(point.inverse_depth);
    return median_of(std::move(values));
}

/// Inverse depth = coefficients . (x, y, 1), x and y from -1 to 1 over the picture.
Eigen::Vector3d basis(const DepthView& view, const Eigen::Vector2d& pixel) {
    return {2 * pixel.x() / view.camera.width_px - 1, 2 * pixel.y() / view.camera.height_px - 1, 1};
}

Eigen::Vector3d fitted_plane(const DepthView& view) {
    constexpr int kRounds = 20;
    Eigen::Vector3d plane(0, 0, middle_inverse_depth(view));
    for (int round = 0; round < kRounds; ++round) {
        std::vector<double> residuals;
        for (const SparsePoint& point : view.points) {
            residuals.push_back(
                std::abs(point.inverse_depth - plane.dot(basis(view, point.pixel))));
        }
        const double scale = std::max(median_of(residuals), 1e-12 * std::abs(plane.z()));
        if (scale <= 0) break;
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < view.points.size(); ++i) {
            const Eigen::Vector3d row = basis(view, view.points[i].pixel);
            const double ratio = residuals[i] / (2 * scale);
            const double weight = 1 / (1 + ratio * ratio);
            normal += weight * row * row.transpose();
            right_side += weight * view.points[i].inverse_depth * row;
        }
        // Points on one line tell no slant across it.
        normal.diagonal().head<2>().array() += 1e-6 * normal(2, 2);
        plane = normal.ldlt().solve(right_side);
    }
    return plane;
}

}  // namespace

DepthMap plane_depth(const DepthView& view) {
    const int width = view.camera.width_px;
    const int height = view.camera.height_px;
    return {FloatImage(width, height, static_cast<float>(middle_inverse_depth(view))),
            GrayImage(width, height, kModelled)};
}

DepthMap slanted_plane_depth(const DepthView& view) {
    constexpr std::size_t kMinPoints = 6;
    DepthMap map = plane_depth(view);
    if (view.points.size() < kMinPoints) return map;
    const Eigen::Vector3d plane = fitted_plane(view);
    for (int y = 0; y < map.inverse_depth.height(); ++y) {
        for (int x = 0; x < map.inverse_depth.width(); ++x) {
            const double value = plane.dot(basis(view, {x + 0.5, y + 0.5}));
            map.inverse_depth(x, y) = static_cast<float>(std::max(0.0, value));
        }
    }
    return map;
}

}  // namespace lumi
