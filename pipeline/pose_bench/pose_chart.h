#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/pose_bench/pose_trial.h"

namespace lumi {

/// What the chart of this stage is drawn from: features kept by size of the pictures by mapper with
/// our own front end, some with COLMAP's, and each lens model.
[[nodiscard]] std::vector<PoseMeans> chart_means(int max_width_px);

/// One line a trial.
[[nodiscard]] std::string trials_csv(const std::vector<PoseTrial>& trials);

/// CPU seconds against position error (the share of photographs not placed where no truth is
/// known), drawn as `file`. Throws what gnuplot_svg throws.
void draw_pose_chart(const std::vector<PoseTrial>& trials, const std::string& title,
                     const std::filesystem::path& file, const Progress& progress);

}  // namespace lumi
