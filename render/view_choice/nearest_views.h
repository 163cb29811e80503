#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The views that look, at places in the eye's picture, most nearly from the eye's direction, the
/// nearest first.
///
/// The picture is divided into cells, kSightSteps (view_sight.h) in each direction, and all pixels
/// of a cell have the views of its middle; those beyond the picture, of the cell next to them. What
/// is there is not known: it is supposed as in view_sight.h. As the eye moves, views change places
/// in one cell and another, never in the whole picture at once.
class NearestViews {
 public:
    /// Finds, for the cells that hold these pixels, at most `most` views each.
    NearestViews(const Lumigraph& lumigraph, const Eye& eye,
                 const std::vector<Eigen::Vector2d>& pixels, std::size_t most);

    /// The views of a pixel, in a cell that was asked for; without those that do not see it.
    [[nodiscard]] const std::vector<int>& at(const Eigen::Vector2d& pixel) const;

 private:
    [[nodiscard]] std::size_t cell_of(const Eigen::Vector2d& pixel) const;
    [[nodiscard]] Eigen::Vector2d middle_of(std::size_t cell) const;

    Camera camera_;
    std::vector<std::vector<int>> views_of_cell_;
};

}  // namespace lumi
