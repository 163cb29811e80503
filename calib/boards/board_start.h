#pragma once

#include <optional>
#include <vector>

#include "calib/boards/lens_fit.h"

namespace lumi {

/// Where an optimisation may start: a focal length and the poses it goes with.
///
/// Tries a ladder of focal lengths over a sample of the photographs, solves all poses for each, and
/// keeps the one whose median photograph is explained best. No closed form that distortion or one
/// bad photograph could lead astray. `model` is SIMPLE_PINHOLE or OPENCV_FISHEYE (equidistant:
/// then fields of view beyond 180 degrees start as well as narrow ones). Views without a pose get
/// none. Empty when not even half of the photographs have one.
struct BoardStart {
    Camera lens;
    std::vector<std::optional<BoardPose>> cam_from_board;
    double median_rms_px = 0.0;
};
[[nodiscard]] std::optional<BoardStart> start_of_calibration(const BoardViews& board,
                                                             LensModel model);

}  // namespace lumi
