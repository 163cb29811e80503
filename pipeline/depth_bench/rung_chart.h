#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/depth_bench/rung_measurement.h"

namespace lumi {

[[nodiscard]] nlohmann::ordered_json rungs_json(const std::vector<RungMeasurement>& measured);

/// Writes rungs.json, rungs.csv and rungs.svg into `folder`, where nothing else is touched:
/// held-out error against CPU seconds per megapixel, logarithmic, one line a scene, error bars of
/// one standard error. Throws what gnuplot_svg throws, and writes nothing then.
void write_rung_chart(const std::filesystem::path& folder,
                      const std::vector<RungMeasurement>& measured, const Progress& progress);

}  // namespace lumi
