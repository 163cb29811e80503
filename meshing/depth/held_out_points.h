#pragma once

#include <optional>
#include <string>

#include "calib/work/progress.h"
#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// A view with fewer points is not asked.
constexpr std::size_t kMinTrialPoints = 40;

/// 95th percentile of how far a rung is from points it was not told, in pixels of disparity.
///
/// Of each sampled view four parts of the points are kept back in turn; of a rung that compares
/// photographs, which do without most points anyway, the first part only. Its neighbours keep their
/// photographs. Up to four views far apart are asked. Nothing when no view has enough points.
/// Throws Interrupted like all work.
[[nodiscard]] std::optional<double> held_out_points_p95_px(const DepthScene& scene,
                                                           const std::string& model, int threads,
                                                           const Progress& progress);

}  // namespace lumi
