#include "render/surroundings/picture_cells.h"

#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

constexpr double kCellsAcross = 24.0;
constexpr double kSmallestCell_px = 8.0;

/// The cell of a coordinate, or the nearest.
int cell_at(double pixel, double cell_px, int cells) {
    return static_cast<int>(std::clamp(std::floor(pixel / cell_px), 0.0, cells - 1.0));
}

}  // namespace

PictureCells::PictureCells(const Camera& camera)
    : PictureCells(camera, std::max(kSmallestCell_px,
                                    std::max(camera.width_px, camera.height_px) / kCellsAcross)) {}

PictureCells::PictureCells(const Camera& camera, double cell_px)
    : cell_px_(cell_px),
      columns_(static_cast<int>(std::ceil(camera.width_px / cell_px_))),
      rows_(static_cast<int>(std::ceil(camera.height_px / cell_px_))),
      marked_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

bool PictureCells::is_any_marked() const {
    return std::find(marked_.begin(), marked_.end(), true) != marked_.end();
}

PictureCells::Block PictureCells::touched_by(const Eigen::Vector2d& low_px,
                                             const Eigen::Vector2d& high_px) const {
    if (high_px.x() < 0 || high_px.y() < 0 || low_px.x() > columns_ * cell_px_ ||
        low_px.y() > rows_ * cell_px_)
        return {};
    return {cell_at(low_px.x(), cell_px_, columns_), cell_at(high_px.x(), cell_px_, columns_) + 1,
            cell_at(low_px.y(), cell_px_, rows_), cell_at(high_px.y(), cell_px_, rows_) + 1};
}

}  // namespace lumi
