#pragma once

#include <filesystem>

namespace lumi {

/// What all files below a folder hold, in MiB: of a package, what has to be handed over.
[[nodiscard]] double folder_mib(const std::filesystem::path& folder);

}  // namespace lumi
