#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

}  // namespace lumi
