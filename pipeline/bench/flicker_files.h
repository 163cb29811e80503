#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/bench/flicker_benchmark.h"

namespace lumi {

[[nodiscard]] nlohmann::ordered_json flicker_json(const std::vector<FlickerFigures>& all);

/// Writes flicker.json, flicker.svg (how much pictures change, frame by frame) and jump-MODE.png:
/// the pictures before and after the largest jump, and four times their difference, side by side.
/// Throws Error (E-CHART-GNUPLOT, E-FILE-WRITE).
void write_flicker_files(const std::filesystem::path& folder,
                         const std::vector<FlickerFigures>& all, const Progress& progress);

}  // namespace lumi
