#pragma once

#include <functional>
#include <vector>

#include "calib/capture/inverse_depth_warp.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// The raster that a map is carried into: a picture with margins on each side.
struct WarpRaster {
    int width = 0;  ///< With both margins.
    int height = 0;
    int margin_x = 0;
    int margin_y = 0;
};

/// A row of another view's map on its way into a raster.
struct WarpedRow {
    std::vector<int> columns;
    std::vector<int> rows;  ///< -1: does not fall into the raster, or is not known.
    std::vector<float> inverse_depths;
};

/// Carries every `step`th row of a map by the warp, and calls `take(y, row)` for each: entry x of
/// it is where pixel (x, y) of the map falls.
void warp_rows(const DepthMap& map, const InverseDepthWarp& warp, const WarpRaster& raster,
               int step, const std::function<void(int, const WarpedRow&)>& take);

}  // namespace lumi
