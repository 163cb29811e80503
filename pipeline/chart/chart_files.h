#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "calib/work/progress.h"
#include "pipeline/chart/chart_result.h"

namespace lumi {

/// What chart.json says: the sweep, every point with its figures and intervals, the times of every
/// stage and repetition, the front, and how much of the work came from the cache.
[[nodiscard]] nlohmann::ordered_json chart_json(const ChartResult& result);

/// One row a point, with a heading: for spreadsheets.
[[nodiscard]] std::string chart_csv(const ChartResult& result);

/// Writes chart.json, chart.csv, NAME.svg of every plot, and chart.html with all of them inside.
void write_chart_files(const std::filesystem::path& folder, const ChartResult& result,
                       const Progress& progress);

}  // namespace lumi
