#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lumi {

/// Types that two headers of the rooms define under one name, in words: "pipeline/b.h:3: Scene is
/// in calib/a.h, too". Both are `lumi::Scene`: a program that links both takes the destructor of
/// the one for the other's, and no tool says so.
[[nodiscard]] std::vector<std::string> type_names_taken_twice(
    const std::filesystem::path& repository);

}  // namespace lumi
