#pragma once

#include <cstdint>
#include <vector>

#include "calib/capture/capture.h"
#include "pipeline/synth/scene.h"

namespace lumi {

/// Up to `count` points of the scene's surfaces, drawn evenly over the photographs' pixels, each
/// with the exact pixels of all views that truly see it; points that fewer than two views see are
/// left out. Colours are left black.
[[nodiscard]] std::vector<ScenePoint> exact_scene_points(const Scene& scene, const Capture& capture,
                                                         int count, std::uint64_t seed);

}  // namespace lumi
