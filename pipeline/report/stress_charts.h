#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "pipeline/workspace/workspace.h"

namespace lumi {

/// What `lumi stress` leaves in its folder: its figures, and a chart of each perturbation.
inline constexpr const char* kStressFiguresName = "stress.json";
[[nodiscard]] std::filesystem::path stress_chart_path(const std::filesystem::path& stress_folder,
                                                      const std::string& perturbation);

/// The charts in a workspace's folder `stress` by perturbation, as far as its figures have curves
/// of them and are of the package that stands there: what one that is gone could bear would be read
/// as this one's. None where the figures or the package are damaged or not there.
[[nodiscard]] std::map<std::string, std::filesystem::path> stress_charts_of(
    const WorkspaceLayout& workspace);

}  // namespace lumi
