#include "render/renderer/mode_reference.h"

#include "calib/work/error.h"
#include "render/modes/adaptive.h"
#include "render/reference/depth_of_others.h"
#include "render/reference/reference_renderer.h"
#include "render/reference/triangle_reference.h"
#include "render/rivals/heigl.h"
#include "render/subdivision/paper_subdivision.h"
#include "render/surroundings/surroundings.h"
#include "render/surroundings/triangle_surroundings.h"
#include "render/uploaded/photograph_lod.h"

namespace lumi {
namespace {

/// The layers of the mode, each over those before.
Frame draw_adaptive(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options) {
    std::vector<BlendTriangles> layers =
        adaptive_layers(lumigraph, searched_views(lumigraph), eye, options);
    const TriangleReference reference(lumigraph, eye, PlaceInterpolation::kLinear,
                                      options.debug_picture);
    Frame frame = empty_frame(eye.camera);
    if (are_surroundings_drawn(options)) {
        frame.color = surroundings_picture(lumigraph, eye);
        set_surroundings(lumigraph, small_photographs(lumigraph), eye, layers.front(),
                         unsure_border_px(photograph_lod(lumigraph, eye)));
    }
    reference.draw(layers.front(), frame);
    for (auto layer = layers.begin() + 1; layer != layers.end(); ++layer)
        reference.lay_over(*layer, frame);
    return frame;
}

/// In the three passes of `paper2001`.
Frame draw_in_passes(const std::vector<FacePolygon>& polygons, const Lumigraph& lumigraph,
                     const Eye& eye, const RenderOptions& options) {
    const BlendTriangles triangles =
        paper_triangles(polygons, lumigraph, searched_views(lumigraph), eye, options);
    return draw_reference(triangles, lumigraph, eye, PlaceInterpolation::kProjective,
                          options.debug_picture);
}

Frame draw_heigl(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options) {
    const std::vector<FacePolygon> polygons = heigl_polygons(lumigraph, eye);
    return corrects_depth_of_heigl(lumigraph, options)
               ? draw_in_passes(polygons, lumigraph, eye, options)
               : draw_reference(lumigraph, eye, options, polygons);
}

void expect_drawable(const RenderOptions& options) {
    const auto refuse = [&](const std::string& what) {
        throw Error(ErrorKind::kUsage, "E-RENDER-REFERENCE",
                    name_of(options.mode) + " in plain code: " + what, "leave out --reference");
    };
    if (options.supersample) refuse("one sample a pixel is drawn, not four");
    if (options.debug_picture == DebugPicture::kGrid) refuse("there is no grid to show");
}

}  // namespace

Frame draw_mode_reference(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& wanted) {
    expect_drawable(wanted);
    if (lacks_depth(lumigraph))
        return draw_mode_reference(with_depth_of_others(lumigraph), eye, wanted);
    const RenderOptions options = possible_options(wanted, lumigraph.has_depth());
    switch (options.mode) {
        case RenderMode::kAdaptive:
            return draw_adaptive(lumigraph, eye, options);
        case RenderMode::kPaper2001:
            return draw_in_passes(face_polygons(lumigraph.mesh, eye), lumigraph, eye, options);
        case RenderMode::kHeigl:
            return draw_heigl(lumigraph, eye, options);
        default:
            return draw_reference(lumigraph, eye, options);
    }
}

}  // namespace lumi
