#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// Tiles are the squares of pixels that share a search range.
constexpr int kTileSide = 16;

/// Number of tiles along so many pixels.
[[nodiscard]] constexpr int tiles_along(int pixels) { return (pixels + kTileSide - 1) / kTileSide; }

/// Where a tile's surface is looked for: parallel planes with the slant that a coarser level or the
/// scene points suggest. Matching windows on a floor or a receding wall then compare what belongs
/// together, and a slanted surface is as smooth as a frontal one (compare SGM-P, Scharstein et al.
/// 2017).
struct TileSurface {
    InverseDepthRange at_centre;
    /// What most of it spans: enough where memory does not allow more.
    InverseDepthRange core = at_centre;
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< Inverse depth per pixel, right and down.
};

/// The same range for every tile of a picture, with the slopes of `guide` (a map of any size that
/// covers the same field of view) unless it is empty.
[[nodiscard]] std::vector<TileSurface> search_whole_range(const InverseDepthRange& range, int width,
                                                          int height, const FloatImage& guide);

/// Around each tile, the slope that most of `found` follows and the range that is spanned by all
/// in the tile and nine tenths of what lies within half a tile around; its core is spanned by the
/// middle three fifths of both. `found` is a map of the same
/// field of view, of at most this size; `tolerance` is the inverse depth within which a pixel
/// follows a surface.
[[nodiscard]] std::vector<TileSurface> search_around(const FloatImage& found, int width, int height,
                                                     double tolerance);

/// Widens the range of each tile to take in the scene points that fall into it; `scale` is the
/// width of the picture as a share of the view's.
void include_points(const DepthView& view, double scale, int width,
                    std::vector<TileSurface>& tiles);

}  // namespace lumi
