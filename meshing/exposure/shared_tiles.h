#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "calib/work/progress.h"
#include "meshing/surface/pictured_view.h"

namespace lumi {

/// Surfaces that two views share, in a tile of the first one's picture.
struct SharedTile {
    /// 0 or 1: the field of a chequerboard, so that one colour can be asked for the other.
    std::size_t fold = 0;
    /// How much brighter they are in the second one's photograph: the natural logarithm of the
    /// ratio of their light, red, green and blue, the median over the tile.
    Eigen::Vector3d log_ratio = Eigen::Vector3d::Zero();
    /// How much farther from the middle of its picture the second view has them: the squared
    /// tangent of their angle to the optical axis there, less that in the first one.
    double lever = 0.0;
};

struct SharedTiles {
    int first = 0;
    int second = 0;
    std::vector<SharedTile> tiles;
    /// Not where one photograph is black and white, and the other is compared with it as such: then
    /// the channels of a tile say the same.
    bool tell_white_balance = true;
};

/// What each view and the eight that share most with it show of the same surfaces, each pair once.
///
/// Photographs are averaged in linear light on a coarse raster; a place counts for a pair when
/// both views have seen depth there, not only filled it, each finds the other's surface, and
/// neither is nearly black or saturated. A photograph that is black and white among others that are
/// not tells nothing of white balance, and its partners are compared with it without their colors.
[[nodiscard]] std::vector<SharedTiles> shared_tiles(const std::vector<PicturedView>& views,
                                                    int threads, const Progress& progress);

/// Of three channels each by itself.
[[nodiscard]] Eigen::Vector3d channelwise_median(const std::vector<Eigen::Vector3d>& samples);

}  // namespace lumi
