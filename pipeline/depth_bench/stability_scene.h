#pragma once

#include <cstdint>

#include "calib/capture/capture.h"
#include "pipeline/depth_bench/depth_hazard.h"
#include "pipeline/synth/scene.h"

namespace lumi {

/// How far the middle camera of a stability scene is from its wall, world units.
constexpr double kWallDistance = 4.0;

/// What stands before the cameras.
[[nodiscard]] Scene stability_scene(DepthHazard hazard, double strength, std::uint64_t seed);

/// The cross of cameras, without points: the middle, left, right, above, below.
[[nodiscard]] Capture stability_cameras(DepthHazard hazard, double strength);

}  // namespace lumi
