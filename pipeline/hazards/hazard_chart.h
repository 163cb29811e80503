#pragma once

#include <filesystem>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/hazards/trial.h"

namespace lumi {

/// One panel a hazard as an SVG file: position error of lumi and of COLMAP alone against strength,
/// refusals on a line of their own above, the bound and the breaking point (where lumi first no
/// longer ends with right poses) marked. Throws what gnuplot_svg throws, and then leaves an old
/// picture untouched.
void draw_hazard_chart(const std::filesystem::path& svg, const std::vector<Trial>& trials,
                       const Progress& progress);

}  // namespace lumi
