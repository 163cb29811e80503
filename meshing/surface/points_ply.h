#pragma once

#include <vector>

#include "calib/capture/capture.h"
#include "calib/work/whole_file.h"

namespace lumi {

/// Binary little-endian PLY of scene points with colours, without their tracks: x y z, red green
/// blue. Places are floats, or doubles where floats would round them by more than a thousandth of
/// what usually lies between two points: far from the world's origin.
[[nodiscard]] Bytes points_ply(const std::vector<ScenePoint>& points);

}  // namespace lumi
