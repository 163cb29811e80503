#pragma once

#include <vector>

#include "calib/capture/image.h"
#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// What a tile counts that the other photograph does not see.
constexpr double kTileUnseen = -1.0;

/// One of the views that a photograph is predicted from, with its finished depth.
struct PredictingView {
    const DepthView* view = nullptr;
    const FloatImage* inverse_depth = nullptr;
};

/// How far a photograph is from what `views` and their depth predict of it: mean squared difference
/// in grey levels, at most 80 levels a pixel, of each tile of 32 x 32 pixels of `photograph`, row
/// by row. Squares are what drawings are judged by, too: silhouettes count. The exposures are
/// evened by one factor first. The view must have had no part in the depth: the difference then
/// tells how well depth predicts a photograph (virtual rephotography, Waechter et al. 2017).
///
/// Predicted is the surface that most of the views put before a pixel, in the mean grey of the
/// views that see it there, nearer views counting more: what one view hides another shows, and what
/// one view alone has wrong the others overrule, as in a drawing.
[[nodiscard]] std::vector<double> photograph_loss(const std::vector<PredictingView>& views,
                                                  const DepthView& photograph);

/// True when the tiles of `next` are closer than those of `current` by more than so many standard
/// errors, and by more than a tenth of a decibel. Compared are decibels, tile by tile: of sums of
/// squares the few tiles where both are badly wrong would hide what happens in all others. False
/// with fewer than 30 tiles that both know.
[[nodiscard]] bool is_clearly_closer(const std::vector<double>& next,
                                     const std::vector<double>& current, double standard_errors);

/// Root of the mean over the tiles that are seen; 0 without any.
[[nodiscard]] double rms_of(const std::vector<double>& tiles);

}  // namespace lumi
