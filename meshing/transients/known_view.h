#pragma once

#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "calib/capture/inverse_depth_warp.h"
#include "calib/capture/rigid3.h"
#include "meshing/exposure/color_match.h"
#include "meshing/surface/depth_map.h"
#include "meshing/surface/pictured_view.h"

namespace lumi {

/// A view at the raster of its depth map, or a coarser one, and what it knows.
struct KnownView {
    Camera camera;
    Rigid3 cam_from_world;
    DepthMap known;         ///< Confidence 0 where it is a guess.
    ColorImage picture;     ///< Averaged (color_match.h).
    std::vector<int> near;  ///< Views that share most of its sight, the nearest first.
    /// How far the fastest-moving of the nearest four that have parallax (parallax.h) sees a pixel
    /// move, per unit of inverse depth (median over the picture). 0 where there are none.
    double disparity_px_per_inverse_depth = 0.0;
};

/// In rasters whose longer side is at most this. At most twelve views are near to each.
[[nodiscard]] std::vector<KnownView> known_views(const std::vector<PicturedView>& views,
                                                 int max_side_px, int threads);

/// Another view, asked about the pixels of a view.
struct Witness {
    int view = 0;
    InverseDepthWarp own_from_other;
    InverseDepthWarp other_from_own;
    ColorMatch match;
};

/// The views near to a view, but those that share too little with it to compare colours.
[[nodiscard]] std::vector<Witness> witnesses_of(const std::vector<KnownView>& views,
                                                int view_index);

}  // namespace lumi
