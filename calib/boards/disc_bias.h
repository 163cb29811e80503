#pragma once

#include "calib/boards/lens_fit.h"

namespace lumi {

/// The views with each point moved from the centroid of a disc as seen, to where the disc's centre
/// is seen: perspective and distortion part the two (Heikkila, Geometric camera calibration using
/// circular control points, PAMI 2000). `seen` holds the centroids as measured; the difference is
/// that of the predicted disc, by Green's formula over its projected outline.
[[nodiscard]] BoardViews without_disc_bias(const BoardViews& seen, const BoardSolution& solution);

/// The same and the fit in turn, from a fit to centroids as seen, until both agree.
void correct_discs(BoardViews& board, BoardSolution& solution);

}  // namespace lumi
