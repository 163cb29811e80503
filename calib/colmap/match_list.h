#pragma once

#include <vector>

#include "calib/features/features.h"

namespace lumi {

/// Matches of a pair of photographs by their look alone.
struct PairMatches {
    int first = 0;  ///< Photographs by index, first < second.
    int second = 0;
    std::vector<FeatureMatch> matches;
};

}  // namespace lumi
