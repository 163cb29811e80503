#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/capture/image.h"
#include "render/lumigraph/lumigraph.h"
#include "render/surroundings/picture_cells.h"
#include "render/surroundings/small_photographs.h"

namespace lumi {

/// Colours at the corners of the marked cells over a picture; between them they vary linearly on
/// two triangles a cell, above and below the diagonal from its top left.
struct ColorGrid {
    PictureCells cells;
    /// Colours of all corners of cells, row by row, 0 to 255; black where no cell is marked.
    std::vector<Eigen::Vector3f> colors;

    [[nodiscard]] std::size_t corner_index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns() + 1) +
               static_cast<std::size_t>(column);
    }
    [[nodiscard]] const Eigen::Vector3f& corner(int column, int row) const {
        return colors[corner_index(column, row)];
    }
    /// The colour at a pixel in a marked cell.
    [[nodiscard]] Eigen::Vector3f at(const Eigen::Vector2d& pixel) const {
        return at(pixel, pixel);
    }
    /// The colour at a pixel by the linear function of the triangle that another place lies on, in
    /// a marked cell.
    [[nodiscard]] Eigen::Vector3f at(const Eigen::Vector2d& pixel,
                                     const Eigen::Vector2d& on_triangle) const;
};

/// What an eye would see, were there nothing but colours: a guess for where no photograph shows
/// anything, so that a picture goes on beyond the capture instead of ending in black. It knows no
/// shapes, and cannot be mistaken for a photograph.
///
/// The scene is its plane (scene_plane.h). Each view tells the colour of the place in its
/// photograph, or of the nearest place at its border; views count the less the larger the angle
/// between them and the eye, and those that do not show the place the less the farther it lies
/// outside. Of many views the twelve that count most in the picture are asked, each the less the
/// nearer it comes to being the thirteenth. Steady in the eye: colours do not jump. `small` holds
/// as many pictures as there are views; the photographs of `lumigraph` are not looked at. Of the
/// cells of the eye's picture only the marked ones get their colours.
[[nodiscard]] ColorGrid surrounding_colors(const Lumigraph& lumigraph,
                                           const SmallPhotographs& small, const Eye& eye,
                                           const PictureCells& cells);

/// The whole of such a picture. In blocks of pixels colours vary as on the triangle on which the
/// block's middle lies.
[[nodiscard]] ColorImage surroundings_picture(const Lumigraph& lumigraph, const Eye& eye,
                                              int block_side_px = 1);

}  // namespace lumi
