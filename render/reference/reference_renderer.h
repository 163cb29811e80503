#pragma once

#include <optional>
#include <vector>

#include "render/faces/face_polygons.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Rays blended pixel by pixel in plain code: what `perpixel` and `lightfield` are tested against.
/// Slow and clear. Other modes than `perpixel` come out as rays on one plane; with `polygons`,
/// which do not overlap, from the views that these name, instead of those of the camera mesh. All
/// views have depth, or none (depth_of_others.h).
[[nodiscard]] Frame draw_reference(const Lumigraph& lumigraph, const Eye& eye,
                                   const RenderOptions& options,
                                   const std::optional<std::vector<FacePolygon>>& polygons = {});

}  // namespace lumi
