#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/config/config_variant.h"

namespace lumi {

/// How much is tried: the table [growth] of a configuration,
///
///     [growth]
///     photographs = [7, 14, 28]     # the first so many, in order of name
///     max_width_px = [384, 768]     # of all photographs
struct GrowthPlan {
    std::vector<int> photographs;
    std::vector<int> widths_px;

    [[nodiscard]] bool is_empty() const { return photographs.empty() && widths_px.empty(); }
};

/// Throws Error (E-CONFIG-...).
[[nodiscard]] GrowthPlan read_growth_plan(const ConfigDocument& document);

/// What a stage took for so many photographs of such a size, in a process of its own.
struct GrowthSample {
    std::string stage;
    int photographs = 0;
    double megapixels = 0.0;  ///< Of one working copy, on average.
    double cpu_s = 0.0;
    double wall_s = 0.0;
    double peak_mib = 0.0;
};

struct GrowthResult {
    std::vector<GrowthSample> by_photographs;
    std::vector<GrowthSample> by_size;
    std::vector<std::string> failures;  ///< "14 photographs: " and failure_text.
};

/// Builds the capture with fewer photographs and with smaller ones, each stage by `program` (lumi
/// itself) in a process of its own, so that its memory is its own. What was measured before in
/// `folder` is kept. A size that cannot be built is noted and the others go on; when none can be,
/// the first failure is thrown: E-GROWTH-STAGE, E-GROWTH-PHOTOS when the photographs are no folder.
/// Throws Error (E-CHILD-..., E-INTERRUPTED).
[[nodiscard]] GrowthResult measure_growth(const ConfigDocument& document, const GrowthPlan& plan,
                                          const std::filesystem::path& program,
                                          const std::filesystem::path& folder, int threads,
                                          Progress& progress);

}  // namespace lumi
