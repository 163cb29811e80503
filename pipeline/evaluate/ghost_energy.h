#pragma once

#include <vector>

#include "calib/work/progress.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Ghost energy at each pixel of an eye's frame: the variance, under the blending weights, of what
/// the cameras that are blended say about it,
///
///     G = sum_{i < j} w_i w_j (y_i - y_j)^2 = sum_i w_i y_i^2 - (sum_i w_i y_i)^2,
///
/// in squared 8-bit luma. It is 0 where the cameras agree or one counts alone, needs no truth, and
/// tells where wrong depth doubles edges. Works with any mode that blends the cameras of a face:
/// cameras are sorted into classes so that no face has two of one class, and one frame a class
/// shows the weight and the luma of each; weights below a sixteenth do not count. Pixels that are
/// not covered are 0. Throws Error (E-GL-...).
[[nodiscard]] std::vector<FloatImage> ghost_energies(const Lumigraph& lumigraph,
                                                     const std::vector<Eye>& eyes, RenderMode mode,
                                                     Progress& progress);

/// A class for each of `view_count` views, from 0, so that the cameras of a face, or without faces
/// those that an eye's frame is blended from, have different ones; views that are blended with none
/// are in class 0.
[[nodiscard]] std::vector<int> camera_classes(const CameraMesh& mesh, int view_count,
                                              const std::vector<Eye>& eyes);

}  // namespace lumi
