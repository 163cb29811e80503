#pragma once

#include <filesystem>
#include <functional>

#include "pipeline/chart/chart_result.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Asked of each variant once it is measured: true when those after it are not needed.
using IsEnough = std::function<bool(const MeasuredVariant&)>;

/// Builds every variant of a sweep in `folder` (stages that variants share are made once), draws
/// each in every mode and compares with the held-out photographs at the largest size of all. What
/// was made before is not made again. A variant that cannot be built is noted with its error and
/// the others go on. Variants after the first that `is_enough` are left out of the result. Throws
/// Error: that of the first variant when none could be built, as take_chart_folder,
/// E-INTERRUPTED.
[[nodiscard]] ChartResult run_sweep(const Sweep& sweep, const std::filesystem::path& folder,
                                    int threads, Progress& progress,
                                    const IsEnough& is_enough = {});

}  // namespace lumi
