#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "pipeline/chart/chart_result.h"
#include "pipeline/line/placed_photographs.h"
#include "pipeline/target/wish.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// A package that was made to meet a wish, and what it measures now.
struct Delivery {
    Wish wish;
    ChartPoint chosen;
    std::vector<std::string> settings;  ///< "depth.model = sweep".
    Achievement promised;               ///< By the chart.
    Achievement delivered;              ///< Measured again on the package.
    PlacedPhotographs photographs;
};

/// Builds the setting of the measured sweep that suits the wish in `workspace`, without what the
/// sweep made, and measures it again; should it miss, the next candidates are tried. Returns the
/// first that meets the wish, or, after `kMaxDeliveries`, the one that comes nearest; that one
/// stands in the workspace. Throws Error (as run_line and evaluate_held_out do).
[[nodiscard]] Delivery deliver(const Wish& wish, const ChartResult& chart,
                               const Workspace& workspace, int threads, Progress& progress);

constexpr int kMaxDeliveries = 3;

[[nodiscard]] nlohmann::ordered_json delivery_json(const Delivery& delivery);

}  // namespace lumi
