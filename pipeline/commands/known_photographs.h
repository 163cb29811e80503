#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/image.h"
#include "calib/work/error.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The names of the photographs that a package's frames can be compared with.
struct KnownPhotographs {
    std::vector<std::string> names;  ///< Of the package first, then held out from it; each once.
    std::optional<Error> failure;    ///< Why those that were held out are not known.
};

/// Of a package, and of the workspace that it lies in, if it lies in one.
[[nodiscard]] KnownPhotographs known_photographs(const std::filesystem::path& package,
                                                 const Lumigraph& lumigraph);

/// A photograph and the eye that it was taken from, both upright.
struct KnownPhotograph {
    Eye eye;
    ColorImage photograph;
    bool is_of_package = false;  ///< Or else it was held out from it.
};

/// The only one of them that `wanted` names (index_of_name). Throws Error (E-RENDER-VIEW: there is
/// none; what known_photographs tells as a failure and held_out_views_beside throws).
[[nodiscard]] KnownPhotograph photograph_named(const std::string& wanted,
                                               const std::filesystem::path& package,
                                               const Lumigraph& lumigraph);

}  // namespace lumi
