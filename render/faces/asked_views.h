#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "render/faces/face_polygons.h"

namespace lumi {

/// How many of a face's views are not among those that are asked for depth.
[[nodiscard]] std::size_t unasked_views(const std::array<int, 3>& views,
                                        const std::vector<int>& asked);

/// The same polygons, each with those of its views first that are asked; neither those nor the
/// others change their order.
[[nodiscard]] std::vector<FacePolygon> asked_first(const std::vector<FacePolygon>& polygons,
                                                   const std::vector<int>& asked);

}  // namespace lumi
