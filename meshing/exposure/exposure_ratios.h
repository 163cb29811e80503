#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "calib/work/progress.h"
#include "meshing/surface/pictured_view.h"

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
};

/// The ratios between each view and the eight that share most with it, each pair once.
///
/// Photographs are averaged in linear light on a coarse raster; a place counts for a pair when
/// both views have seen depth there, each finds the other's surface, and neither is nearly black or
/// saturated. Of each tile the median counts, and of the tiles of a colour their median: highlights
/// and what moved are outvoted. Pairs with fewer than three tiles of a colour are left out.
[[nodiscard]] std::vector<ExposureRatio> exposure_ratios(const std::vector<PicturedView>& views,
                                                         int threads, const Progress& progress);

}  // namespace lumi
