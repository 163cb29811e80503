#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "calib/work/progress.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Where pictures of what was painted over lie in the pack stage's folder.
constexpr const char* kTransientFolder = "transients";

/// Takes out of the Lumigraph what was there for one photograph alone (transient_removal.h), notes
/// it, and writes each such photograph, small, before and after, into `pack_folder`/transients.
/// Returns their names, files and shares of the picture: the stage's evidence. Where views that are
/// painted at one time would take more than `max_memory_mib`, they are fewer.
[[nodiscard]] nlohmann::ordered_json remove_transients(Lumigraph& lumigraph,
                                                       const std::filesystem::path& pack_folder,
                                                       int threads, int max_memory_mib,
                                                       Progress& progress);

}  // namespace lumi
