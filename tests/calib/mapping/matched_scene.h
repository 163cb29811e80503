#pragma once

#include <vector>

#include "calib/colmap/colmap_database.h"
#include "tests/calib/adjust/synthetic_capture.h"

namespace lumi {

/// A synthetic capture as its photographs, matched: feature i of a photograph is the i-th of the
/// scene's points that it sees.
struct MatchedScene {
    Capture truth;
    std::vector<ColmapCamera> cameras;
    std::vector<ColmapPhotograph> photographs;
    std::vector<VerifiedPair> pairs;  ///< Of all photographs that share a point.
};
[[nodiscard]] MatchedScene matched_scene(Capture truth);

/// Moves the second ends of this share of all matches to other features.
void confuse_matches(MatchedScene& scene, double share, unsigned seed);

/// The largest distance of a centre from the truth after the best similarity, by the largest
/// distance between two true centres.
[[nodiscard]] double relative_position_error(const Capture& estimate, const Capture& truth);

[[nodiscard]] std::vector<std::string> names_of(const Capture& capture);

}  // namespace lumi
