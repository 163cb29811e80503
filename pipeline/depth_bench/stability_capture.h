#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/work/progress.h"
#include "meshing/surface/depth_map.h"
#include "pipeline/depth_bench/depth_hazard.h"

namespace lumi {

/// Photographs of a synthetic scene under a hazard.
struct StabilityCapture {
    PosedPhotographs told;      ///< What depth is found from: harmed pictures, or wrong cameras.
    PosedPhotographs harmless;  ///< The same places, rightly told, without what harms the picture.
    /// One a view; confidence 0 where a pixel is not asked (the hazards "thin" and "steps").
    std::vector<DepthMap> truth;
};

/// Five cameras in a cross before a wall with objects drawn by lot from `seed`; pictures of 320 x
/// 240 pixels are written below `folder`. Of different strengths all but the hazard is the same.
[[nodiscard]] StabilityCapture stability_capture(DepthHazard hazard, double strength,
                                                 std::uint64_t seed,
                                                 const std::filesystem::path& folder, int threads,
                                                 Progress& progress);

}  // namespace lumi
