#pragma once

#include <vector>

#include "render/modes/face_polygons.h"

namespace lumi {

/// Sorts the polygons so that painting them in turn leaves, at each pixel, the face that is crossed
/// last on the way from the eye: the rule of weights_of_ray.
///
/// On a kernel mesh no two polygons overlap and the order is the given one. Elsewhere pairs that
/// overlap are compared where they do, and sorted topologically (Newell, Newell, Sancha 1972). A
/// cycle, which no order can paint, is entered at its first polygon.
[[nodiscard]] std::vector<FacePolygon> in_paint_order(std::vector<FacePolygon> polygons);

}  // namespace lumi
