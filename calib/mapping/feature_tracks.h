#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "calib/colmap/colmap_database.h"

namespace lumi {

/// A feature of a photograph that shows a track's scene point.
struct TrackElement {
    int photograph = 0;
    std::uint32_t feature = 0;
    friend bool operator==(const TrackElement&, const TrackElement&) = default;
};

/// The features, at most one of each photograph and at least two, that show one scene point.
/// Ascending by photograph.
using FeatureTrack = std::vector<TrackElement>;

/// Joins matches into tracks, the matches of the pairs with most inliers first. A match that would
/// give a track two features of one photograph is left out, and the tracks stay apart (compare
/// Moulon and Monasse, Unordered feature tracking made fast and easy, CVMP 2012, which drops such
/// tracks). `feature_counts` has one entry per photograph. Ascending by their first elements.
[[nodiscard]] std::vector<FeatureTrack> join_tracks(const std::vector<std::size_t>& feature_counts,
                                                    const std::vector<VerifiedPair>& pairs);

}  // namespace lumi
