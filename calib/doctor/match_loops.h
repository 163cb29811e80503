#pragma once

#include <vector>

#include "calib/colmap/colmap_database.h"

namespace lumi {

/// What becomes of features that are followed from a photograph to a second, a third and back.
struct MatchLoops {
    int closed = 0;     ///< Loops that end at the feature where they began.
    int conflicts = 0;  ///< Loops that end at another place of the same photograph.

    /// 0 where nothing could be followed.
    [[nodiscard]] double conflict_share() const {
        return closed + conflicts == 0 ? 0.0
                                       : static_cast<double>(conflicts) / (closed + conflicts);
    }
};

/// Follows the matches of verified pairs around triplets of photographs. True matches close; things
/// that look alike are matched with one another in one pair and told apart in another, and their
/// loops do not (Zach, Klopschitz, Pollefeys, Disambiguating visual relations using loop
/// constraints, CVPR 2010, on features instead of rotations: no lens needs to be known). Each pair
/// is followed through the few photographs that it shares most with.
[[nodiscard]] MatchLoops follow_matches(const std::vector<ColmapPhotograph>& photographs,
                                        const std::vector<const VerifiedPair*>& pairs);

}  // namespace lumi
