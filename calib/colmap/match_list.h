#pragma once

#include <string>
#include <vector>

#include "calib/features/features.h"

namespace lumi {

/// Matches of a pair of photographs by their look alone.
struct PairMatches {
    int first = 0;  ///< Photographs by index, first < second.
    int second = 0;
    std::vector<FeatureMatch> matches;
};

/// COLMAP's raw match list: two image names, a line per match, an empty line; for each pair.
[[nodiscard]] std::string colmap_match_list(const std::vector<PairMatches>& pairs);

}  // namespace lumi
