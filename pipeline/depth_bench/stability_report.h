#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/depth_bench/stability_trial.h"

namespace lumi {

[[nodiscard]] nlohmann::ordered_json stability_json(const std::vector<StabilityTrial>& trials);

/// One row of the table for people: right shares in percent; "!" where a model claims too much.
[[nodiscard]] std::string stability_row(const StabilityTrial& trial);
/// The table, and where each model breaks.
[[nodiscard]] std::string stability_text(const std::vector<StabilityTrial>& trials);

/// stability.json, stability.csv and a chart stability-HAZARD.svg of the last trial's hazard (right
/// share against strength, one line a model, breaking points dashed) into `folder`. Throws Error
/// (E-FILE-WRITE, E-CHART-GNUPLOT).
void write_stability_report(const std::filesystem::path& folder,
                            const std::vector<StabilityTrial>& trials, const Progress& progress);

}  // namespace lumi
