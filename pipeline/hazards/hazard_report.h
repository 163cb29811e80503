#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/hazards/trial.h"

namespace lumi {

/// How often a program was right, honest or wrong.
struct EndingCounts {
    int tried = 0;
    int right = 0;
    int refused = 0;
    int false_successes = 0;
    int failed = 0;
    double cpu_s = 0.0;
};

struct StressSummary {
    int trials = 0;
    EndingCounts lumi;
    EndingCounts colmap;
    int harmless = 0;          ///< Trials at the first strength of their hazard.
    int harmless_refused = 0;  ///< Of these, refused by lumi.
    int reasons_right = 0;     ///< Of all trials: see reason_is_right().
    int troubled = 0;          ///< Trials in which lumi's poses did not come out right.
    int troubled_reasons_right = 0;
    double doctor_cpu_s = 0.0;
};

[[nodiscard]] StressSummary summary_of(const std::vector<Trial>& trials);
[[nodiscard]] nlohmann::ordered_json hazards_json(const std::vector<Trial>& trials);
[[nodiscard]] std::string hazards_csv(const std::vector<Trial>& trials);
/// A table for people, and a row of it.
[[nodiscard]] std::string trial_text(const Trial& trial);
[[nodiscard]] std::string hazards_text(const std::vector<Trial>& trials);

/// hazards.json, hazards.csv and hazards.svg (a panel a hazard: error and ending against strength,
/// the breaking point marked) into `folder`. Throws what draw_hazard_chart throws.
void write_hazard_report(const std::filesystem::path& folder, const std::vector<Trial>& trials,
                         const Progress& progress);

}  // namespace lumi
