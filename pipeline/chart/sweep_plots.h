#pragma once

#include <string>
#include <vector>

#include "pipeline/chart/chart_result.h"
#include "pipeline/chart/plot.h"

namespace lumi {

/// A plot and the name of its file.
struct NamedPlot {
    std::string name;
    Plot plot;
    std::string caption;
};

/// Speed against accuracy: end to end (seconds from photographs to the first picture against FLIP),
/// drawing (milliseconds a frame), size of the package, and one for each stage whose settings were
/// varied, the settings of all other stages being those of the most accurate point.
[[nodiscard]] std::vector<NamedPlot> plots_of(const ChartResult& result);

/// The points that nothing beats: indices into `points`, by rising cost.
[[nodiscard]] std::vector<std::size_t> front_by_build_time(const std::vector<ChartPoint>& points);
[[nodiscard]] std::vector<std::size_t> front_by_frame_time(const std::vector<ChartPoint>& points);

}  // namespace lumi
