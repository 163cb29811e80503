#pragma once

#include <vector>

#include "render/faces/face_polygons.h"

namespace lumi {

/// Leaves of each polygon what is seen of it when all are painted in turn, so that each pixel has
/// the face that is crossed last on the way from the eye: the rule of weights_of_ray.
///
/// On a kernel mesh no two polygons overlap and nothing changes. Elsewhere pairs that overlap are
/// compared where they do, and sorted topologically (Newell, Newell, Sancha 1972); a cycle, which
/// no order can paint, is entered at its first polygon. What later ones cover is cut away: where
/// the eye is close to a camera several faces would each fill the picture.
[[nodiscard]] std::vector<FacePolygon> without_overlaps(std::vector<FacePolygon> polygons);

}  // namespace lumi
