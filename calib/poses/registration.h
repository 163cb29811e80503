#pragma once

#include <cstddef>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/colmap/colmap_database.h"
#include "calib/ingest/ingest.h"

namespace lumi {

/// Photographs with fewer features show hardly any detail.
inline constexpr std::size_t kHardlyAnyFeatures = 50;

/// Drops the views with `is_dropped`, what they saw, and the points that fewer than two others see.
void drop_views(Capture& capture, const std::vector<char>& is_dropped);

/// Drops views that see fewer than `min_points` points: too few to hold a pose.
void drop_weak_views(Capture& capture, std::size_t min_points);

/// Drops the cameras that no view has. Returns which are left: their indices before, ascending.
std::vector<std::size_t> drop_unused_cameras(Capture& capture);

/// The photographs without a view, each with the reason: E-POSES-NOFEATURES (hardly any
/// features), E-POSES-NOMATCH (no pair with a placed photograph), E-POSES-WEAK (too few points in
/// common, or none that two placed photographs show, or no place fits them). In the order of the
/// photographs.
[[nodiscard]] std::vector<LeftOut> explain_unregistered(
    const Capture& capture, const std::vector<Photograph>& photographs,
    const std::vector<ColmapPhotograph>& features, const std::vector<VerifiedPair>& pairs);

}  // namespace lumi
