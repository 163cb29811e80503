#include "meshing/depth/surrounding_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "meshing/depth/inverse_depth_warp.h"

namespace lumi {
namespace {

constexpr double kMarginX = 0.5;  // Of the picture's width: a neighbour looks that far aside.
constexpr double kMarginY = 0.25;

void splat(const DepthMap& from, const InverseDepthWarp& warp, SurroundingDepth& target) {
    DepthMap& map = target.map;
    const auto width = static_cast<double>(map.confidence.width());
    const auto height = static_cast<double>(map.confidence.height());
    const Eigen::Vector3d right = warp.infinite_homography.col(0);
    for (int y = 0; y < from.confidence.height(); ++y) {
        Eigen::Vector3d ray = warp.infinite_homography * Eigen::Vector3d(0.5, y + 0.5, 1);
        for (int x = 0; x < from.confidence.width(); ++x, ray += right) {
            if (from.confidence(x, y) == 0) continue;
            const auto inverse_depth = static_cast<double>(from.inverse_depth(x, y));
            const Eigen::Vector3d there = ray + inverse_depth * warp.epipole;
            if (there.z() <= 0) continue;
            const double column = std::floor(there.x() / there.z()) + target.margin_x;
            const double row = std::floor(there.y() / there.z()) + target.margin_y;
            if (!(column >= 0 && row >= 0 && column < width && row < height)) continue;
            const auto value = static_cast<float>(inverse_depth / there.z());
            const int to_x = static_cast<int>(column);
            const int to_y = static_cast<int>(row);
            if (map.confidence(to_x, to_y) != 0 && map.inverse_depth(to_x, to_y) >= value) continue;
            map.inverse_depth(to_x, to_y) = value;
            map.confidence(to_x, to_y) = 255;
        }
    }
}

/// Median of what is known in the 3 x 3 pixels around each.
DepthMap condensed(const DepthMap& map) {
    constexpr std::size_t kMinHits = 4;
    DepthMap result{FloatImage(map.confidence.width(), map.confidence.height()),
                    GrayImage(map.confidence.width(), map.confidence.height())};
    std::array<float, 9> hits;
    for (int y = 1; y + 1 < map.confidence.height(); ++y) {
        for (int x = 1; x + 1 < map.confidence.width(); ++x) {
            std::size_t count = 0;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    if (map.confidence(x + dx, y + dy) == 0) continue;
                    hits[count++] = map.inverse_depth(x + dx, y + dy);
                }
            }
            if (count < kMinHits) continue;
            const auto middle = hits.begin() + static_cast<std::ptrdiff_t>(count / 2);
            std::nth_element(hits.begin(), middle,
                             hits.begin() + static_cast<std::ptrdiff_t>(count));
            result.inverse_depth(x, y) = *middle;
            result.confidence(x, y) = 255;
        }
    }
    return result;
}

/// The view's neighbours, and theirs: what lies beside the picture may be seen by no neighbour.
std::set<int> views_around(const DepthScene& scene, int view_index) {
    std::set<int> around;
    for (const int j : scene.views[static_cast<std::size_t>(view_index)].neighbours) {
        around.insert(j);
        const std::vector<int>& next = scene.views[static_cast<std::size_t>(j)].neighbours;
        around.insert(next.begin(), next.end());
    }
    around.erase(view_index);
    return around;
}

/// Within its picture the view has seen for itself what can be known.
void forget_picture(const DepthView& view, SurroundingDepth& surrounding) {
    for (int y = 0; y < view.camera.height_px; ++y) {
        std::uint8_t* row =
            surrounding.map.confidence.row(y + surrounding.margin_y) + surrounding.margin_x;
        std::fill_n(row, view.camera.width_px, std::uint8_t{0});
    }
}

}  // namespace

SurroundingDepth surrounding_depth(const DepthScene& scene, const std::vector<DepthMap>& maps,
                                   int view_index) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    SurroundingDepth surrounding;
    surrounding.margin_x = static_cast<int>(kMarginX * view.camera.width_px);
    surrounding.margin_y = static_cast<int>(kMarginY * view.camera.height_px);
    const int width = view.camera.width_px + 2 * surrounding.margin_x;
    const int height = view.camera.height_px + 2 * surrounding.margin_y;
    surrounding.map = {FloatImage(width, height), GrayImage(width, height)};
    for (const int j : views_around(scene, view_index)) {
        const auto index = static_cast<std::size_t>(j);
        const DepthView& other = scene.views[index];
        splat(maps[index],
              warp_b_from_a(other.camera, other.cam_from_world, view.camera, view.cam_from_world),
              surrounding);
    }
    surrounding.map = condensed(surrounding.map);
    forget_picture(view, surrounding);
    return surrounding;
}

}  // namespace lumi
