#include "meshing/warp/warped_rows.h"

#include <array>

#include "meshing/warp/instruction_sets.h"

namespace lumi {
namespace {

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

RowWarp warp_of_row(const InverseDepthWarp& warp, int y, const WarpRaster& raster) {
    // A margin of m pixels is m * z in homogeneous pixels.
    Eigen::Matrix3d with_margins = Eigen::Matrix3d::Identity();
    with_margins(0, 2) = raster.margin_x;
    with_margins(1, 2) = raster.margin_y;
    const Eigen::Matrix3d homography = with_margins * warp.infinite_homography;
    const auto floats = [](const Eigen::Vector3d& v) {
        return std::array<float, 3>{static_cast<float>(v.x()), static_cast<float>(v.y()),
                                    static_cast<float>(v.z())};
    };
    return {floats(homography * Eigen::Vector3d(0.5, y + 0.5, 1)), floats(homography.col(0)),
            floats(with_margins * warp.epipole)};
}

}  // namespace

void warp_rows(const DepthMap& map, const InverseDepthWarp& warp, const WarpRaster& raster,
               int step, const std::function<void(int, const WarpedRow&)>& take) {
    const auto width = static_cast<std::size_t>(map.confidence.width());
    WarpedRow warped{std::vector<int>(width), std::vector<int>(width), std::vector<float>(width)};
    for (int y = 0; y < map.confidence.height(); y += step) {
        const RowWarp row_warp = warp_of_row(warp, y, raster);
        run_fastest<WarpRow>(map.inverse_depth.row(y), map.confidence.row(y),
                             map.confidence.width(), &row_warp, raster.width, raster.height,
                             warped.columns.data(), warped.rows.data(),
                             warped.inverse_depths.data());
        take(y, warped);
    }
}

}  // namespace lumi
