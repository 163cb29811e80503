#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/viewer/commands.h"

namespace lumi {

/// The names of the photographs that were held out in the workspace that the package lies in,
/// whether or not they found a place; none where it lies in no workspace. Throws Error
/// (E-JSON-READ).
[[nodiscard]] std::vector<std::string> held_out_names_beside(
    const std::filesystem::path& package_folder);

/// The held-out photographs of the workspace that the package lies in, upright, without what a
/// lens of `light_falloff` (light_left.h) took from them; 0: as they are. None where the package
/// lies in no workspace, or nothing was held out. Throws what held_out_photographs throws, and
/// Error for a photograph that cannot be read.
[[nodiscard]] std::vector<HeldOutView> held_out_views_beside(
    const std::filesystem::path& package_folder, double light_falloff);

}  // namespace lumi
