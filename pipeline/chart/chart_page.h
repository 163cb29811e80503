#pragma once

#include <string>
#include <vector>

#include "pipeline/chart/chart_result.h"

namespace lumi {

/// A plot as it is shown.
struct DrawnPlot {
    std::string svg;
    std::string caption;
};

/// One page without anything outside it: what to choose, the plots, every point as a table.
[[nodiscard]] std::string chart_page(const ChartResult& result,
                                     const std::vector<DrawnPlot>& plots);

}  // namespace lumi
