#pragma once

#include <optional>
#include <string>

#include "calib/work/progress.h"
#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// A view with fewer points is not asked.
constexpr std::size_t kMinTrialPoints = 40;
/// A rung is astray at a point that it misses by more, in pixels of disparity.
constexpr double kAstrayPx = 2.0;

/// How far a rung is from points it was not told.
struct HeldOutPoints {
    double p95_px = 0.0;  ///< 95th percentile over all of them, in pixels of disparity.
    /// Share of points at which the rung is astray, of those that agree with the points around
    /// them: a lone point may be wrong itself, many together are a part of the scene.
    double astray_share = 0.0;
};

/// Of each sampled view four parts of the points are kept back in turn; of a rung that compares
/// photographs, which do without most points anyway, the first part only. Its neighbours keep their
/// photographs. Up to four views far apart are asked. Nothing when no view has enough points.
/// Throws Interrupted like all work.
[[nodiscard]] std::optional<HeldOutPoints> held_out_points(const DepthScene& scene,
                                                           const std::string& model, int threads,
                                                           const Progress& progress);

}  // namespace lumi
