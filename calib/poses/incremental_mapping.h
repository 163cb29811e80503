#pragma once

#include <optional>

#include "calib/capture/capture.h"
#include "calib/poses/mapping_job.h"

namespace lumi {

/// Runs our own incremental mapper; then, while photographs are missing, with fewer matches asked
/// of each, with more lenient matches between the placed and the missing, and from more features
/// (`matched` is then replaced). Empty when no two photographs make a start.
[[nodiscard]] std::optional<Capture> map_incrementally(const MappingJob& job,
                                                       MatchedPhotographs& matched);

}  // namespace lumi
