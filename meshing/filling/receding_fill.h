#pragma once

#include <optional>
#include <vector>

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Whether depth that was continued beyond all that is known should recede.
///
/// A carpet goes on at the border of the picture, but behind the rim of a skull there is a room,
/// out of focus and too smooth for any window. A continued rim would stand in the way of what other
/// views see beside it. Continued pixels may therefore recede by some pixels of disparity for each
/// pixel of their distance from what is known: a slope, because a jump would tear the surface, and
/// tears are drawn in the colours of the rim.

/// Differences of colour between the continued pixels of one view and what its neighbours see
/// there, one sum for each slope; empty where too few can be compared.
[[nodiscard]] std::vector<double> recession_differences(const DepthScene& scene,
                                                        const std::vector<DepthMap>& confirmed_maps,
                                                        int view_index, const DepthMap& continued,
                                                        const FloatImage& distance_px);

/// The slope at which the photographs differ least, in pixels of disparity a pixel; 0 unless they
/// differ less than without, by more than two standard errors over the views. Empty where fewer
/// than four views can tell. `differences` are those of some views.
[[nodiscard]] std::optional<double> chosen_recession(
    const std::vector<std::vector<double>>& differences);

/// Lets the pixels of `map` recede by `slope_px` times the distance over which they were continued.
void recede(double slope_px, double one_pixel, const FloatImage& distance_px, DepthMap& map);

}  // namespace lumi
