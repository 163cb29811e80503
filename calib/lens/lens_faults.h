#pragma once

#include <string>

#include "calib/capture/camera.h"

namespace lumi {

/// Why a fitted lens cannot be one, however well it explains the pixels that it was fitted to;
/// empty when nothing speaks against it. `farthest` is the largest distance of a seen pixel from
/// the principal point, in focal lengths.
///
/// - Folding: two directions that go to one pixel within `farthest`.
/// - A rational distortion (FULL_OPENCV) with a pole, in the complex plane, nearer than `farthest`
///   and a zero beside it that cancels it (a Froissart doublet; Baker and Graves-Morris, Pade
///   Approximants, 1996, section 2.2). It bends the picture within a narrow ring, as no glass
///   does, and leaves parameters that only just make up for each other.
[[nodiscard]] std::string lens_fault(const Camera& lens, double farthest);

}  // namespace lumi
