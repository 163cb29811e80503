#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pipeline/dataset/run_dataset.h"

namespace lumi {

[[nodiscard]] nlohmann::ordered_json dataset_json(const std::string& name,
                                                  const std::vector<SceneOutcome>& outcomes);

/// Writes dataset.json, dataset.csv, dataset.svg (seconds against error, one mark a scene; only
/// when a scene was measured) and dataset.html with a table of all scenes.
void write_dataset_files(const std::filesystem::path& folder, const std::string& name,
                         const std::vector<SceneOutcome>& outcomes, const Progress& progress);

}  // namespace lumi
