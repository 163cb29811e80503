#include "render/subdivision/outline_cells.h"

#include <Eigen/Core>
#include <cmath>

#include "calib/capture/inverse_depth_warp.h"
#include "render/transfer/view_geometry.h"

namespace lumi {
namespace {

constexpr double kCell_px = 4.0;  ///< Of the eye's picture.
/// By how much what is behind an outline moves against it, in pixels of the view's photograph: what
/// is missed of lesser steps is hardly seen, and costs as many triangles.
constexpr double kLeastStep_px = 12.0;

int cells_of(int length_px) { return static_cast<int>(std::ceil(length_px / kCell_px)); }

}  // namespace

OutlineCells::OutlineCells(const Lumigraph& lumigraph, const SearchedViews& views,
                           const std::vector<int>& view_indices, const Eye& eye)
    : columns_(cells_of(eye.camera.width_px)),
      rows_(cells_of(eye.camera.height_px)),
      counts_(place(0, rows_ + 1), 0) {
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    for (const int index : view_indices) {
        const auto i = static_cast<std::size_t>(index);
        const LumigraphView& view = lumigraph.views[i];
        const InverseDepthWarp eye_from_view = warp_from(view).to(eye);
        const double disparity_px =
            disparity_px_per_inverse_depth(views.geometries[i], eye_in_world);
        for (const OutlinePoint& point : views.outlines[i]) {
            if (static_cast<double>(point.step) * disparity_px < kLeastStep_px) continue;
            const Eigen::Vector2d pixel(point.x_px, point.y_px);
            const auto in_eye = eye_from_view.at(pixel, static_cast<double>(point.inverse_depth));
            if (in_eye) mark(in_eye->pixel);
        }
    }
    sum_up();
}

/// In the cell to the right of and below its own place: sums begin with 0.
void OutlineCells::mark(const Eigen::Vector2d& pixel) {
    const Eigen::Vector2d cell = pixel / kCell_px;
    if (cell.minCoeff() < 0 || cell.x() >= columns_ || cell.y() >= rows_) return;
    counts_[place(static_cast<int>(cell.x()) + 1, static_cast<int>(cell.y()) + 1)] = 1;
}

void OutlineCells::sum_up() {
    for (int row = 1; row <= rows_; ++row)
        for (int column = 1; column <= columns_; ++column)
            counts_[place(column, row)] += counts_[place(column - 1, row)] +
                                           counts_[place(column, row - 1)] -
                                           counts_[place(column - 1, row - 1)];
}

bool OutlineCells::has_beside(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
    if (counts_.empty()) return false;
    const Eigen::Vector2i size(columns_, rows_);
    const Eigen::Vector2i begin =
        (from.cwiseMin(to) / kCell_px).cast<int>().cwiseMax(Eigen::Vector2i::Zero()).cwiseMin(size);
    const Eigen::Vector2i end =
        ((from.cwiseMax(to) / kCell_px).cast<int>() + Eigen::Vector2i::Ones())
            .cwiseMax(begin)
            .cwiseMin(size);
    return counts_[place(end.x(), end.y())] + counts_[place(begin.x(), begin.y())] >
           counts_[place(begin.x(), end.y())] + counts_[place(end.x(), begin.y())];
}

}  // namespace lumi
