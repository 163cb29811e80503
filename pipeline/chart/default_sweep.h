#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/config/config_variant.h"

namespace lumi {

/// The longest side of any photograph; 0 where that cannot be told (a video, no photographs).
[[nodiscard]] int longest_side_px(const std::filesystem::path& photographs_or_video);

/// The values of a list, where ["all"] under depth.model stands for every depth model of this
/// version.
[[nodiscard]] ConfigList with_all_spelled_out(ConfigList list);

/// What is tried when a configuration does not say: every depth model that this version has, and
/// working copies of the configured size (or that of the photographs, where they are smaller), of
/// three quarters and of half of it.
[[nodiscard]] std::vector<ConfigList> default_sweep(const ConfigDocument& document);

}  // namespace lumi
