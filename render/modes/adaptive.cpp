#include "render/modes/adaptive.h"

#include "render/modes/scene_plane.h"

namespace lumi {

Adaptive::Adaptive(const UploadedLumigraph& uploaded) : uploaded_(uploaded), blend_(uploaded) {}

DrawStatistics Adaptive::draw(const Eye& eye, const RenderOptions& options, const Viewport&) {
    const Lumigraph& layout = uploaded_.layout;
    const DepthSearch search(layout, uploaded_.geometries, eye, options.occlusion_tolerance_px);
    const AdaptiveSubdivision subdivision =
        adaptive_subdivision(face_polygons(layout.mesh, eye), search,
                             scene_plane_inverse_depth(layout, eye), options.correct_occlusion,
                             {.max_error_px = options.triangle_error_px,
                              .min_edge_px = options.min_triangle_px,
                              .max_edge_px = options.max_triangle_px,
                              .max_triangles = options.max_triangles});
    blend_.draw(subdivision.triangles, eye, options);
    return {subdivision.triangles.count()};
}

}  // namespace lumi
