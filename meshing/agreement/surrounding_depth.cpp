#include "meshing/agreement/surrounding_depth.h"

#include <algorithm>

#include "meshing/agreement/gap_closing.h"
#include "meshing/depth_scene/views_around.h"
#include "meshing/warp/warped_rows.h"

namespace lumi {
namespace {

constexpr double kMarginX = 0.5;  // Of the picture's width: a neighbour looks that far aside.
constexpr double kMarginY = 0.25;

void splat(const DepthMap& from, const InverseDepthWarp& warp, const GrayImage& picture,
           SurroundingDepth& target) {
    DepthMap& map = target.map;
    const WarpRaster raster{map.confidence.width(), map.confidence.height(), target.margin_x,
                            target.margin_y};
    warp_rows(from, warp, raster, 1, [&](int, const WarpedRow& warped) {
        for (std::size_t i = 0; i < warped.rows.size(); ++i) {
            if (warped.rows[i] < 0) continue;
            const int column = warped.columns[i];
            const int row = warped.rows[i];
            if (picture.contains(column - target.margin_x, row - target.margin_y)) continue;
            // What is not known is 0 and no nearer than anything.
            float& nearest = map.inverse_depth(column, row);
            nearest = std::max(nearest, warped.inverse_depths[i]);
            map.confidence(column, row) = kKnown;
        }
    });
}

void put_within(const DepthMap& picture, SurroundingDepth& surrounding) {
    for (int y = 0; y < picture.confidence.height(); ++y) {
        for (int x = 0; x < picture.confidence.width(); ++x) {
            const int column = x + surrounding.margin_x;
            const int row = y + surrounding.margin_y;
            surrounding.map.inverse_depth(column, row) = picture.inverse_depth(x, y);
            surrounding.map.confidence(column, row) = picture.confidence(x, y);
        }
    }
}

}  // namespace

SurroundingDepth surrounding_depth(const DepthScene& scene, const std::vector<DepthMap>& maps,
                                   int view_index, const DepthMap& within) {
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
        splat(maps[index], warp_from(other).to(view), within.confidence, surrounding);
    }
    surrounding.map = with_gaps_closed(surrounding.map);
    put_within(within, surrounding);
    return surrounding;
}

}  // namespace lumi
