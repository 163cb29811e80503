#include "render/reference/reference_holes.h"

#include "render/holes/hole_cells.h"
#include "render/holes/hole_triangles.h"
#include "render/reference/triangle_reference.h"

namespace lumi {

Frame filled_holes(const Lumigraph& lumigraph, const AgreedDepth& depth, const Eye& eye,
                   const RenderOptions& options) {
    const PictureCells cells =
        hole_cells(eye.camera, [&](const Eigen::Vector2d& pixel) { return depth.is_hole(pixel); });
    AdaptiveSubdivider subdivider;
    return draw_reference(
        hole_triangles(lumigraph, searched_views(lumigraph), eye, options, cells, subdivider),
        lumigraph, eye, PlaceInterpolation::kLinear, options.debug_picture);
}

}  // namespace lumi
