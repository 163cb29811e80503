#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pipeline/chart/growth.h"
#include "pipeline/chart/sweep_plots.h"

namespace lumi {

/// CPU seconds and peak memory of every stage against the number of photographs and their size, the
/// fitted exponents in the key. Plots without two different sizes are left out.
[[nodiscard]] std::vector<NamedPlot> growth_plots(const GrowthResult& growth);

/// Samples, and exponents with their standard errors.
[[nodiscard]] nlohmann::ordered_json growth_json(const GrowthResult& growth);

/// Writes growth.json, growth.csv, SVGs and growth.html.
void write_growth_files(const std::filesystem::path& folder, const std::string& name,
                        const GrowthResult& growth, const Progress& progress);

}  // namespace lumi
