#include "meshing/depth/surrounding_depth.h"

#include <algorithm>
#include <array>
#include <set>

#include "meshing/depth/instruction_sets.h"
#include "meshing/depth/inverse_depth_warp.h"

namespace lumi {
namespace {

constexpr double kMarginX = 0.5;  // Of the picture's width: a neighbour looks that far aside.
constexpr double kMarginY = 0.25;

/// A row of another view's map on its way into the raster of the target.
struct WarpedRow {
    explicit WarpedRow(int width)
        : columns(static_cast<std::size_t>(width)),
          rows(static_cast<std::size_t>(width)),
          inverse_depths(static_cast<std::size_t>(width)) {}

    std::vector<int> columns;
    std::vector<int> rows;  ///< -1: does not fall into the raster.
    std::vector<float> inverse_depths;
};

/// The warp of one row: homogeneous pixel = start + x * right + inverse depth * epipole, the
/// margins of the raster already in it.
struct RowWarp {
    std::array<float, 3> start, right, epipole;
};

struct WarpRow {
    LUMI_KERNEL void run(const float* __restrict inverse_depths,
                         const std::uint8_t* __restrict confidences, int count, const RowWarp* warp,
                         int width, int height, int* __restrict columns, int* __restrict rows,
                         float* __restrict warped) {
        const RowWarp w = *warp;
        const auto right_border = static_cast<float>(width);
        const auto lower_border = static_cast<float>(height);
        for (int i = 0; i < count; ++i) {
            const auto x = static_cast<float>(i);
            const float q = inverse_depths[i];
            const float z = w.start[2] + x * w.right[2] + q * w.epipole[2];
            const float scale = 1.0F / z;
            const float column = (w.start[0] + x * w.right[0] + q * w.epipole[0]) * scale;
            const float row = (w.start[1] + x * w.right[1] + q * w.epipole[1]) * scale;
            const int inside = (confidences[i] != 0) & (z > 1e-6F) & (column >= 0) &
                               (column < right_border) & (row >= 0) & (row < lower_border);
            columns[i] = static_cast<int>(inside != 0 ? column : 0.0F);
            rows[i] = static_cast<int>(inside != 0 ? row : -1.0F);
            warped[i] = q * scale;
        }
    }
};

RowWarp warp_of_row(const InverseDepthWarp& warp, int y, const SurroundingDepth& target) {
    // A margin of m pixels is m * z in homogeneous pixels.
    Eigen::Matrix3d with_margins = Eigen::Matrix3d::Identity();
    with_margins(0, 2) = target.margin_x;
    with_margins(1, 2) = target.margin_y;
    const Eigen::Matrix3d homography = with_margins * warp.infinite_homography;
    const auto floats = [](const Eigen::Vector3d& v) {
        return std::array<float, 3>{static_cast<float>(v.x()), static_cast<float>(v.y()),
                                    static_cast<float>(v.z())};
    };
    return {floats(homography * Eigen::Vector3d(0.5, y + 0.5, 1)), floats(homography.col(0)),
            floats(with_margins * warp.epipole)};
}

void splat(const DepthMap& from, const InverseDepthWarp& warp, SurroundingDepth& target) {
    DepthMap& map = target.map;
    WarpedRow warped(from.confidence.width());
    for (int y = 0; y < from.confidence.height(); ++y) {
        const RowWarp row_warp = warp_of_row(warp, y, target);
        run_fastest<WarpRow>(from.inverse_depth.row(y), from.confidence.row(y),
                             from.confidence.width(), &row_warp, map.confidence.width(),
                             map.confidence.height(), warped.columns.data(), warped.rows.data(),
                             warped.inverse_depths.data());
        for (std::size_t i = 0; i < warped.rows.size(); ++i) {
            if (warped.rows[i] < 0) continue;
            const int column = warped.columns[i];
            const int row = warped.rows[i];
            // What is not known is 0 and no nearer than anything.
            float& nearest = map.inverse_depth(column, row);
            nearest = std::max(nearest, warped.inverse_depths[i]);
            map.confidence(column, row) = 255;
        }
    }
}

/// How many of the 3 x 3 pixels around each are known; 0 along the border.
GrayImage known_around(const GrayImage& confidence) {
    const int width = confidence.width();
    GrayImage sums(width, confidence.height());
    std::vector<std::uint8_t> column_sums(static_cast<std::size_t>(width));
    for (int y = 1; y + 1 < confidence.height(); ++y) {
        const std::uint8_t* above = confidence.row(y - 1);
        const std::uint8_t* own = confidence.row(y);
        const std::uint8_t* below = confidence.row(y + 1);
        for (int x = 0; x < width; ++x) {
            column_sums[static_cast<std::size_t>(x)] =
                static_cast<std::uint8_t>((above[x] & 1) + (own[x] & 1) + (below[x] & 1));
        }
        std::uint8_t* out = sums.row(y);
        for (int x = 1; x + 1 < width; ++x) {
            const std::uint8_t* column = column_sums.data() + x;
            out[x] = static_cast<std::uint8_t>(column[-1] + column[0] + column[1]);
        }
    }
    return sums;
}

/// Median of what is known in the 3 x 3 pixels around (x, y).
float median_around(const DepthMap& map, int x, int y) {
    std::array<float, 9> hits;
    std::size_t count = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            if (map.confidence(x + dx, y + dy) == 0) continue;
            hits[count++] = map.inverse_depth(x + dx, y + dy);
        }
    }
    const auto middle = hits.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(hits.begin(), middle, hits.begin() + static_cast<std::ptrdiff_t>(count));
    return *middle;
}

/// Medians, but of the picture itself: within it the view has seen for itself what can be known.
DepthMap condensed(const SurroundingDepth& surrounding) {
    constexpr std::uint8_t kMinHits = 4;
    const DepthMap& map = surrounding.map;
    const int width = map.confidence.width();
    const int height = map.confidence.height();
    const GrayImage hits = known_around(map.confidence);
    DepthMap result{FloatImage(width, height), GrayImage(width, height)};
    for (int y = 1; y + 1 < height; ++y) {
        const bool beside = y >= surrounding.margin_y && y < height - surrounding.margin_y;
        for (int x = 1; x + 1 < width; ++x) {
            if (beside && x == surrounding.margin_x) x = width - surrounding.margin_x;
            if (hits(x, y) < kMinHits) continue;
            result.inverse_depth(x, y) = median_around(map, x, y);
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
    surrounding.map = condensed(surrounding);
    return surrounding;
}

}  // namespace lumi
