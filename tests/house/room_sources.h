#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

namespace lumi {

/// In the order in which they know each other.
inline constexpr std::array<std::string_view, 4> kRooms{"calib", "meshing", "render", "pipeline"};

/// Every .h, .cpp, .inc and .in file below the rooms of a repository, in order of their paths.
[[nodiscard]] std::vector<std::filesystem::path> room_sources(
    const std::filesystem::path& repository);

}  // namespace lumi
