#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "render/lumigraph/package.h"
#include "render/viewer/commands.h"

namespace lumi {

/// A package and what the window offers beside it.
struct OpenedPackage {
    Lumigraph lumigraph;
    bool fade_beyond_capture = false;     ///< Whether it is drawn so to begin with.
    std::vector<PlannedView> planned{};   ///< Offered in the panel.
    std::vector<HeldOutView> held_out{};  ///< To be compared with; offered in the panel.
    LikenessWords likeness_words{};       ///< Of those; empty: nothing is said.
    std::string message{};                ///< What people are told of it; may be empty.
};

/// Reads the first and every further package of a window. Throws Error.
using PackageLoader = std::function<OpenedPackage(const std::filesystem::path&, Exposures)>;

/// The package that is meant by a path: a package's own folder, its manifest, or a folder, such as
/// a workspace, in which exactly one package lies. Any other path comes back as it is.
[[nodiscard]] std::filesystem::path package_meant_by(const std::filesystem::path& path);

/// A package alone, to be drawn as it was built to be. Throws what read_package throws.
[[nodiscard]] OpenedPackage opened_alone(const std::filesystem::path& package, Exposures exposures);

}  // namespace lumi
