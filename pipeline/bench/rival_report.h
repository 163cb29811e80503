#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pipeline/bench/rival_benchmark.h"

namespace lumi {

[[nodiscard]] nlohmann::ordered_json rival_scenes_json(const std::vector<RivalScene>& scenes);
/// For each method a row of means, and one for each held-out frame, whose `frame` counts from 1.
[[nodiscard]] std::string rivals_csv(const std::vector<RivalScene>& scenes);
/// A table a scene, for people.
[[nodiscard]] std::string rivals_text(const std::vector<RivalScene>& scenes);

/// rivals.json and rivals.csv into `folder`.
void write_rival_report(const std::filesystem::path& folder, const std::vector<RivalScene>& scenes);

}  // namespace lumi
