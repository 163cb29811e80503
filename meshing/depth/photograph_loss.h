#pragma once

#include <vector>

#include "calib/capture/image.h"
#include "meshing/depth/depth_scene.h"

namespace lumi {

/// What a tile counts that the other photograph does not see.
constexpr double kTileUnseen = -1.0;

/// How far another photograph is from showing what `view` shows, by the surface that
/// `inverse_depth` says: mean squared difference in grey levels, at most 80 levels a pixel, of each
/// tile of 32 x 32 pixels, row by row. Squares are what drawings are judged by, too: silhouettes
/// count. The exposures are evened by one factor first. The other view must have had no part in the
/// depth: the difference then tells how well depth predicts a photograph (compare Waechter et al.
/// 2017, virtual rephotography). What is hidden from the other view is wrong for every surface
/// alike.
[[nodiscard]] std::vector<double> photograph_loss(const DepthView& view,
                                                  const FloatImage& inverse_depth,
                                                  const DepthView& other);

/// True when the tiles of `next` are closer than those of `current` by more than a standard error
/// of the difference, and by more than a fiftieth. False with fewer than 30 tiles that both know.
[[nodiscard]] bool is_clearly_closer(const std::vector<double>& next,
                                     const std::vector<double>& current);

/// Root of the mean over the tiles that are seen; 0 without any.
[[nodiscard]] double rms_of(const std::vector<double>& tiles);

}  // namespace lumi
