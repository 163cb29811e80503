#include "render/depth_layers/unknown_cells.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "render/transfer/pixel_transfer.h"

namespace lumi {
namespace {

/// Depth meshes are simplified at the border of a photograph, too.
constexpr double kMargin_px = 2.0;

using CellCorners = std::array<Eigen::Vector3d, 4>;  ///< Homogeneous pixels of the eye.

/// A view as the eye's rays run through it.
class RaysInView {
 public:
    RaysInView(const LumigraphView& view, const TiledDepth& depth, const Eye& eye,
               double max_inverse_depth)
        : camera_(view.camera),
          transfer_(
              pixel_transfer(view.camera, view.cam_from_world, eye.camera, eye.cam_from_world)),
          is_complete_(!depth.empty() && depth.farthest() > 0),
          nearest_depth_(is_complete_ ? 1.0 / static_cast<double>(depth.nearest()) : 0.0),
          max_inverse_depth_(max_inverse_depth) {}

    /// Whether rays through all of the cell meet the view's depth mesh.
    [[nodiscard]] bool surely_meets(const CellCorners& corners) const {
        // The eye's own depth in the view, and what is left before the view's nearest surface.
        const double room = nearest_depth_ - transfer_.per_inverse_depth.z();
        if (!is_complete_ || !(room > 0)) return false;
        double before_all = 0.0;  // The eye's inverse depth there.
        for (const Eigen::Vector3d& corner : corners)
            before_all = std::max(before_all, transfer_.at_infinity.row(2).dot(corner) / room);
        return before_all < max_inverse_depth_ && are_inside(corners, 0.0) &&
               are_inside(corners, before_all);
    }

 private:
    [[nodiscard]] bool are_inside(const CellCorners& corners, double inverse_depth) const {
        return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector3d& corner) {
            const Eigen::Vector3d at =
                transfer_.at_infinity * corner + inverse_depth * transfer_.per_inverse_depth;
            if (!(at.z() > 0)) return false;
            const Eigen::Vector2d pixel = at.hnormalized();
            return pixel.minCoeff() >= kMargin_px && pixel.x() <= camera_.width_px - kMargin_px &&
                   pixel.y() <= camera_.height_px - kMargin_px;
        });
    }

    const Camera& camera_;
    PixelTransfer transfer_;
    bool is_complete_;
    double nearest_depth_;
    double max_inverse_depth_;
};

CellCorners corners_of_cell(const PictureCells& cells, int column, int row) {
    const double left = column * cells.cell_px();
    const double top = row * cells.cell_px();
    const double right = left + cells.cell_px();
    const double bottom = top + cells.cell_px();
    return {Eigen::Vector3d(left, top, 1), Eigen::Vector3d(right, top, 1),
            Eigen::Vector3d(left, bottom, 1), Eigen::Vector3d(right, bottom, 1)};
}

}  // namespace

void mark_where_depth_may_be_unknown(const Lumigraph& lumigraph,
                                     const std::vector<TiledDepth>& depths,
                                     const std::vector<DepthViewSet>& sets, const Eye& eye,
                                     double max_inverse_depth, PictureCells& cells) {
    for (const DepthViewSet& set : sets) {
        std::vector<RaysInView> views;
        for (const int index : set.view_indices) {
            const auto view = static_cast<std::size_t>(index);
            views.emplace_back(lumigraph.views[view], depths[view], eye, max_inverse_depth);
        }
        for (int row = 0; row < cells.rows(); ++row) {
            for (int column = 0; column < cells.columns(); ++column) {
                if (cells.is_marked(column, row)) continue;
                const CellCorners corners = corners_of_cell(cells, column, row);
                const bool is_known =
                    std::any_of(views.begin(), views.end(),
                                [&](const RaysInView& view) { return view.surely_meets(corners); });
                if (!is_known) cells.mark(column, row);
            }
        }
    }
}

}  // namespace lumi
