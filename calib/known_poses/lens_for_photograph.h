#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "calib/ingest/ingest.h"
#include "calib/known_poses/known_poses.h"

namespace lumi {

/// Throws Error (E-IMPORT-SIZE) when the lenses describe other pictures than the photographs that
/// matched: another shape, pictures of one size that have several on disk, or a principal point
/// beyond the photograph. Any of these means that the photographs were cropped, turned or
/// undistorted after the poses were found. `photograph_of_view` is by view.
void refuse_other_pictures(const KnownPoses& known, const std::vector<Photograph>& photographs,
                           const std::vector<std::optional<std::size_t>>& photograph_of_view,
                           const std::filesystem::path& path);

/// The lens for the photograph as it is on disk.
[[nodiscard]] Camera lens_for_original(const KnownLens& lens, const Photograph& photograph);

/// The lens for the working copy.
[[nodiscard]] Camera lens_for_working_copy(const KnownLens& lens, const Photograph& photograph);

}  // namespace lumi
