#pragma once

#include <cstdlib>
#include <filesystem>

namespace lumi {

/// The real photographs that tests labelled `photos` use: where LUMI_PHOTOS points, else beside the
/// project. May not exist.
[[nodiscard]] inline std::filesystem::path photographs_folder() {
    if (const char* folder = std::getenv("LUMI_PHOTOS")) return folder;
    return std::filesystem::path(LUMI_SOURCE_DIR) / "../shared/data";
}

}  // namespace lumi
