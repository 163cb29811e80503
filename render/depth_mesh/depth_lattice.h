#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "calib/capture/camera.h"
#include "meshing/surface/depth_map.h"
#include "render/depth_mesh/surface_tears.h"

namespace lumi {

struct LatticeNode {
    int column = 0;
    int row = 0;
};

/// A view's depth samples as the nodes of a lattice that reaches to the border of its photograph:
/// the samples, and around them one ring of nodes on the border itself, continued from the samples.
/// Specks that are seen amidst what is filled, or filled amidst what is seen, are as what is around
/// them. Beyond the last column and row the lattice goes on as its mirror image, turned about the
/// ring so that slopes go on.
class DepthLattice {
 public:
    /// `disparity_px` turns inverse depth into pixels of the photograph (view_geometry.h).
    DepthLattice(const DepthMap& depth, const Camera& camera, double disparity_px);

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] bool contains(int column, int row) const {
        return column >= 0 && row >= 0 && column < columns_ && row < rows_;
    }

    [[nodiscard]] float inverse_depth(int column, int row) const {
        return inverse_depth_[index(column, row)];
    }
    /// Also of nodes beyond the lattice; 0 at the least.
    [[nodiscard]] float continued_inverse_depth(int column, int row) const;
    /// Seen by the view rather than filled in.
    [[nodiscard]] bool is_seen(int column, int row) const { return seen_[index(column, row)] != 0; }
    /// In pixels of the photograph, or beyond it.
    [[nodiscard]] Eigen::Vector2f position_px(int column, int row) const;

    /// True when the surface tears between a node and its right (lower) neighbour
    /// (surface_tears.h).
    [[nodiscard]] bool tears_right(int column, int row) const;
    [[nodiscard]] bool tears_below(int column, int row) const;
    /// The same for two neighbours in a row or a column.
    [[nodiscard]] bool tears_between(const LatticeNode& a, const LatticeNode& b) const {
        const int column = std::min(a.column, b.column);
        const int row = std::min(a.row, b.row);
        return a.row == b.row ? tears_right(column, row) : tears_below(column, row);
    }

    [[nodiscard]] double disparity_px() const { return disparity_px_; }

 private:
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    [[nodiscard]] bool tears_along(int column, int row, int step_x, int step_y,
                                   double disparity_per_pitch) const;
    void fill_ring();

    int columns_ = 0;
    int rows_ = 0;
    double pitch_x_px_ = 0.0;  ///< Pixels of the photograph between two samples.
    double pitch_y_px_ = 0.0;
    double disparity_px_ = 0.0;
    DisparityPerPitch disparity_per_pitch_;
    std::vector<float> inverse_depth_;
    std::vector<std::uint8_t> seen_;
};

}  // namespace lumi
