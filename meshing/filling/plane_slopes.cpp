#include "meshing/filling/plane_slopes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

constexpr int kSlopeTile_px = 16;
constexpr int kSlopeStride_px = 3;

/// Moments of (x, y, 1) and inverse depth over the known pixels around a tile.
struct Moments {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
    double squares = 0.0;
    int samples = 0;

    void add(const Eigen::Vector3d& row, double value) {
        normal += row * row.transpose();
        right_side += value * row;
        squares += value * value;
        ++samples;
    }
};

PlaneSlopes::Slope slope_of_tile(const DepthMap& map, int column, int row, double one_pixel) {
    Moments moments;
    int all = 0;
    const int centre_x = column * kSlopeTile_px + kSlopeTile_px / 2;
    const int centre_y = row * kSlopeTile_px + kSlopeTile_px / 2;
    double first = 0;  // Values are taken relative to one of them, against cancellation.
    for (int dy = -3 * kSlopeTile_px / 2; dy < 3 * kSlopeTile_px / 2; dy += kSlopeStride_px) {
        for (int dx = -3 * kSlopeTile_px / 2; dx < 3 * kSlopeTile_px / 2; dx += kSlopeStride_px) {
            ++all;
            if (!map.confidence.contains(centre_x + dx, centre_y + dy)) continue;
            if (map.confidence(centre_x + dx, centre_y + dy) == 0) continue;
            const auto value = static_cast<double>(map.inverse_depth(centre_x + dx, centre_y + dy));
            if (moments.samples == 0) first = value;
            moments.add({1.0 * dx, 1.0 * dy, 1.0}, value - first);
        }
    }
    if (3 * moments.samples < all) return {};
    moments.normal.diagonal().head<2>().array() += 1e-6;
    const Eigen::Vector3d plane = moments.normal.ldlt().solve(moments.right_side);
    const double residual = moments.squares - plane.dot(moments.right_side);
    if (residual > one_pixel * one_pixel * moments.samples) return {};
    return {plane.head<2>().cast<float>(), true};
}

}  // namespace

PlaneSlopes plane_slopes(const DepthMap& map, double one_pixel) {
    const int across = (map.confidence.width() + kSlopeTile_px - 1) / kSlopeTile_px;
    const int down = (map.confidence.height() + kSlopeTile_px - 1) / kSlopeTile_px;
    std::vector<PlaneSlopes::Slope> slopes;
    for (int row = 0; row < down; ++row) {
        for (int column = 0; column < across; ++column) {
            slopes.push_back(slope_of_tile(map, column, row, one_pixel));
        }
    }
    return {kSlopeTile_px, across, std::move(slopes)};
}

}  // namespace lumi
