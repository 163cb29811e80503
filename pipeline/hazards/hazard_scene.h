#pragma once

#include <cstdint>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/rigid3.h"
#include "pipeline/hazards/hazard.h"
#include "pipeline/synth/scene.h"

namespace lumi {

/// What stands before the camera, and where it is photographed from.
struct HazardScene {
    Scene scene;
    std::vector<Camera> cameras;         ///< One a photograph.
    std::vector<Rigid3> cam_from_world;  ///< One a photograph: in the middle of its exposure.
};

/// A scene drawn by lot from `seed` (objects, materials, light, lens) and the path on which a
/// hazard of geometry is met; for hazards of the picture alone, a good path. The room is a wall
/// (y = 1.6) behind objects on a floor (z = 0); cameras stand about three units before them.
[[nodiscard]] HazardScene hazard_scene(Hazard hazard, double strength, std::uint64_t seed);

}  // namespace lumi
