#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "calib/work/progress.h"
#include "pipeline/stress/stress_result.h"

namespace lumi {

[[nodiscard]] nlohmann::ordered_json stress_json(const StressResult& result);

/// Writes stress.json, stress.csv, PERTURBATION.svg of each (dB lost against strength, one line a
/// mode, dashed where it breaks), and stress.html with all of them inside.
void write_stress_files(const std::filesystem::path& folder, const StressResult& result,
                        const Progress& progress);

}  // namespace lumi
