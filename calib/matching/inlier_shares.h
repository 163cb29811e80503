#pragma once

#include <vector>

#include "calib/colmap/colmap_database.h"
#include "calib/colmap/match_list.h"

namespace lumi {

/// Of each pair with enough matches by look to tell: the share of them that agrees with one motion
/// of the camera, 0 where none was verified. Both lists ascend by their photographs.
[[nodiscard]] std::vector<double> inlier_shares_of(const std::vector<PairMatches>& matches,
                                                   const std::vector<VerifiedPair>& verified);

}  // namespace lumi
