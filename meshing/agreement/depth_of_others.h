#pragma once

#include <vector>

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// What other views say of the pixels that a view could not confirm itself.
///
/// A wall behind rods is seen by too few neighbours of a view to be found in it, but views farther
/// aside find it with each other. Their confident pixels are carried into the view, and claim those
/// that are unknown there where the two photographs show one colour. Of the claims for a pixel
/// those count that most views make, to a pixel of disparity, and the nearest of these.
///
/// Where they show another colour, the view shows something before what they know: leaves that each
/// photograph has at other places are found by no matching, but the ground behind them is.
struct DepthOfOthers {
    /// A claim of fewer than three views: a matching window carries depth beyond an outline, and
    /// two views may do so alike.
    struct Claim {
        int x = 0;
        int y = 0;
        int view = 0;  ///< One that makes it.
        float inverse_depth = 0.0F;
    };

    DepthMap agreed;              ///< Claims of three views or more: kKnown; else kUnseen.
    std::vector<Claim> doubtful;  ///< Of pixels that are not agreed upon.
    /// What two views or more know, but in another colour, and more than claim anything; small gaps
    /// are closed. kKnown, else kUnseen, as where the view or three others know what it shows. Two
    /// are enough: what is carried beyond an outline is in the colours of what lies behind.
    DepthMap hidden;
};

/// Asks the neighbours of view `view_index`, and theirs.
[[nodiscard]] DepthOfOthers depth_of_others(const DepthScene& scene,
                                            const std::vector<DepthMap>& maps, int view_index);

/// Doubtful claims against what was continued into the same pixels of `map`: a claim takes the
/// pixel if the view that makes it sees what lies behind the continued surface, or another colour
/// there. Such pixels are no longer continued: `distance_px` becomes 0.
void take_claims_against(const DepthScene& scene, const std::vector<DepthMap>& maps, int view_index,
                         std::vector<DepthOfOthers::Claim> claims, DepthMap& map,
                         FloatImage& distance_px);

}  // namespace lumi
