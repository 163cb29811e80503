#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "calib/capture/camera.h"

namespace lumi {

/// Square cells over an eye's picture, some of them marked. They reach over the right and the lower
/// border.
class PictureCells {
 public:
    /// 24 along the longer side, but none smaller than 8 pixels: a block of pixels (pixel_blocks.h)
    /// has the colours of the cell that its middle lies in. None is marked.
    explicit PictureCells(const Camera& camera);
    /// Cells of this size. None is marked.
    PictureCells(const Camera& camera, double cell_px);

    [[nodiscard]] double cell_px() const { return cell_px_; }
    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }

    [[nodiscard]] bool is_marked(int column, int row) const { return marked_[index(column, row)]; }
    [[nodiscard]] bool is_any_marked() const;
    void mark(int column, int row) { marked_[index(column, row)] = true; }
    void mark_all() { marked_.assign(marked_.size(), true); }

    /// Columns and rows, from the first to before the last.
    struct Block {
        int begin_column = 0;
        int end_column = 0;
        int begin_row = 0;
        int end_row = 0;
    };
    /// The cells that a box of pixels touches.
    [[nodiscard]] Block touched_by(const Eigen::Vector2d& low_px,
                                   const Eigen::Vector2d& high_px) const;

 private:
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    double cell_px_;
    int columns_;
    int rows_;
    std::vector<bool> marked_;
};

}  // namespace lumi
