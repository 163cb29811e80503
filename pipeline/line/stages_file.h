#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "calib/work/error.h"
#include "pipeline/workspace/stage_cache.h"

namespace lumi {

/// What stages.json says: per stage its state ("run", "up to date"), seconds, CPU seconds, peak
/// memory and evidence; and, when the line ended early, where and why.
[[nodiscard]] nlohmann::ordered_json stages_json(const std::vector<FinishedStage>& stages);

/// `configuration_sha256` is of what the line was told (told_configuration.h): it tells of which
/// configuration the stages are.
void write_stages_file(const std::filesystem::path& path, const std::vector<FinishedStage>& stages,
                       const std::string& configuration_sha256);
void write_stages_file(const std::filesystem::path& path, const std::vector<FinishedStage>& stages,
                       const std::string& configuration_sha256, const std::string& failed_stage,
                       const Error& failure);

}  // namespace lumi
