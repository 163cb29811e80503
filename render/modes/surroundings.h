#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/capture/image.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Colours at the corners of square cells over a picture, row by row; between them they vary
/// linearly on two triangles a cell, above and below the diagonal from its top left.
struct ColorGrid {
    double cell_px = 1.0;
    int columns = 0;  ///< Of corners.
    int rows = 0;
    std::vector<Eigen::Vector3f> colors;  ///< 0 to 255.

    [[nodiscard]] const Eigen::Vector3f& corner(int column, int row) const {
        return colors[static_cast<std::size_t>(row * columns + column)];
    }
    /// Within the picture.
    [[nodiscard]] Eigen::Vector3f at(const Eigen::Vector2d& pixel) const;
};

/// Photographs so small that only the colours of their regions are left: what guesses are made of.
[[nodiscard]] std::vector<ColorImage> small_photographs(const Lumigraph& lumigraph);

/// What an eye would see, were there nothing but colours: a guess for where no photograph shows
/// anything, so that a picture goes on beyond the capture instead of ending in black. It knows no
/// shapes, and cannot be mistaken for a photograph.
///
/// The scene is its plane (scene_plane.h). Each view tells the colour of the place in its
/// photograph, or of the nearest place at its border; views count the less the larger the angle
/// between them and the eye, and those that do not show the place the less the farther it lies
/// outside. Steady in the eye: colours do not jump. `small` holds as many pictures as there are
/// views; the photographs of `lumigraph` are not looked at.
[[nodiscard]] ColorGrid surrounding_colors(const Lumigraph& lumigraph,
                                           const std::vector<ColorImage>& small, const Eye& eye);

}  // namespace lumi
