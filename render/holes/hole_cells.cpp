#include "render/holes/hole_cells.h"

namespace lumi {
namespace {

/// Place `number` of a cell's kHoleSamples * kHoleSamples, row by row.
Eigen::Vector2d hole_sample_px(int column, int row, int number) {
    const Eigen::Vector2d in_cell(number % kHoleSamples + 0.5, number / kHoleSamples + 0.5);
    return kHoleCell_px * (Eigen::Vector2d(column, row) + in_cell / kHoleSamples);
}

}  // namespace

PictureCells hole_cells(const Camera& camera,
                        const std::function<bool(const Eigen::Vector2d& pixel)>& is_hole) {
    PictureCells cells(camera, kHoleCell_px);
    for (int row = 0; row < cells.rows(); ++row) {
        for (int column = 0; column < cells.columns(); ++column) {
            int inside = 0;
            int holes = 0;
            for (int number = 0; number < kHoleSamples * kHoleSamples; ++number) {
                const Eigen::Vector2d pixel = hole_sample_px(column, row, number);
                if (pixel.x() >= camera.width_px || pixel.y() >= camera.height_px) continue;
                ++inside;
                if (is_hole(pixel)) ++holes;
            }
            if (holes > 0 && holes >= kLeastHoleShare * inside) cells.mark(column, row);
        }
    }
    return cells;
}

}  // namespace lumi
