#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "calib/poses/mapping_job.h"

namespace lumi {

/// Features, matches by look, and their geometric verification, by our own means or, with `[poses]
/// front_end = "colmap"`, by COLMAP's; with more features where the usual ones verify no pair.
/// Throws Error: E-POSES-NOPAIR (no pair has enough matches), E-POSES-TEXTURE (the same, and hardly
/// any features are there), E-COLMAP-...
[[nodiscard]] MatchedPhotographs match_and_verify(const MappingJob& job);

/// The same once more, named `name`, with more features than those of `matched`, by which `placed`
/// photographs were placed, and says so. Empty where these were more already, or where it fails
/// though that is a model: better than none.
[[nodiscard]] std::optional<MatchedPhotographs> match_more_features(
    const MappingJob& job, const MatchedPhotographs& matched, std::size_t placed,
    const std::string& name);

}  // namespace lumi
