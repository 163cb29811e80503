#pragma once

#include <optional>
#include <vector>

#include "calib/capture/inverse_depth_warp.h"
#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Pixels of disparity from which on one surface counts as standing before another.
inline constexpr double kClearlyApartPx = 2.0;

/// Where another view has a point of a surface in its picture.
struct PlaceInView {
    int x = 0;
    int y = 0;
    /// By how much the point stands before what the view knows there, in its inverse depth; 0 where
    /// it knows nothing.
    double ahead = 0.0;
};

/// Of the point at an inverse depth along the ray of pixel (x, y). Empty outside of the picture.
[[nodiscard]] std::optional<PlaceInView> place_in_view(const DepthMap& known,
                                                       const InverseDepthWarp& view_from_own, int x,
                                                       int y, float inverse_depth);

/// 255 where what was continued into `map` stands clearly before what is `hidden` there, and no
/// view around sees past it; else 0.
[[nodiscard]] GrayImage continued_before_hidden(const DepthScene& scene,
                                                const std::vector<DepthMap>& maps, int view_index,
                                                const DepthMap& map, const DepthMap& hidden);

}  // namespace lumi
