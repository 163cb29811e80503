#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "meshing/exposure/shared_tiles.h"

namespace lumi {

/// How much brighter the surfaces that two views share are in the second one's photograph: the
/// natural logarithm of the ratio of their light, red, green and blue.
struct ExposureRatio {
    int first = 0;
    int second = 0;
    /// Of the tiles of a chequerboard over the first picture: of the white fields, and of the
    /// black ones, so that one can be asked for the other.
    std::array<Eigen::Vector3d, 2> log_ratio{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    /// Standard deviation of what single tiles say, over all channels, robust (from the median
    /// absolute deviation): exposure changes all alike, light that falls differently does not.
    double spread = 0.0;
    /// What they say, of each colour.
    std::array<std::vector<Eigen::Vector3d>, 2> tiles = {};
    bool tells_white_balance = true;  ///< See SharedTiles.
};

/// The ratios of pairs of views whose lens loses this much light towards the corners
/// (light_left.h).
///
/// Of the tiles of a colour their median counts: highlights and what moved are outvoted. Pairs with
/// fewer than three tiles of a colour are left out.
[[nodiscard]] std::vector<ExposureRatio> exposure_ratios(const std::vector<SharedTiles>& pairs,
                                                         double light_falloff);

}  // namespace lumi
