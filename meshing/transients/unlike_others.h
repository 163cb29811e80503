#pragma once

#include <cstdint>
#include <vector>

#include "meshing/transients/known_view.h"

namespace lumi {

/// What others say of the rays of a view.
struct OthersAgree {
    /// What two of them and more agree upon, to a pixel of disparity: confidence
    /// kConfirmedBySeveral; else kUnseen.
    DepthMap agreed;
    /// kPerhapsUnlike where these show it alike, and the view another colour; kUnlike where they
    /// are three and more, and most of those that could see it, and the colour differs by twice
    /// their tolerance; else 0. It is 0, too, where the view knows something nearer, as two others
    /// confirm, or two of them show the view's colour on another surface that they agree upon.
    GrayImage is_unlike;

    static constexpr std::uint8_t kPerhapsUnlike = 128;
    static constexpr std::uint8_t kUnlike = 255;
};

/// Asks the witnesses of view `view_index`, the nearest first, at most eight for each pixel.
[[nodiscard]] OthersAgree others_agree(const std::vector<KnownView>& views,
                                       const std::vector<Witness>& witnesses, int view_index);

}  // namespace lumi
