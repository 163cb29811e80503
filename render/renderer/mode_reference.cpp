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
#include "render/transfer/scene_plane.h"

namespace lumi {
namespace {

/// The layers of the mode, each over those before.
Frame draw_adaptive(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options) {
    std::vector<BlendTriangles> layers =
        adaptive_layers(lumigraph, searched_views(lumigraph), eye, options);
    const bool has_surroundings = are_surroundings_drawn(options);
    if (has_surroundings)
        set_surroundings(lumigraph, small_photographs(lumigraph), eye, layers.front());
    BlendTriangles all;
    for (const BlendTriangles& layer : layers) {
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), layer.vertices.begin(), layer.vertices.end());
        for (const std::uint32_t index : layer.indices) all.indices.push_back(first + index);
    }
    return draw_reference(all, lumigraph, eye.camera, PlaceInterpolation::kLinear,
                          has_surroundings ? surroundings_picture(lumigraph, eye) : ColorImage{});
}

Frame draw_paper2001(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options) {
    const SearchedViews views = searched_views(lumigraph);
    const BlendTriangles triangles =
        paper_subdivision(face_polygons(lumigraph.mesh, eye), DepthSearch(lumigraph, views, eye),
                          scene_plane_inverse_depth(lumigraph, eye), inverse_depth_range(lumigraph),
                          options.correct_occlusion, paper_subdivision_options(options));
    return draw_reference(triangles, lumigraph, eye.camera, PlaceInterpolation::kProjective);
}

void expect_drawable(const RenderOptions& options) {
    const bool draws_rays = options.mode == RenderMode::kPerPixel ||
                            options.mode == RenderMode::kLightField ||
                            options.mode == RenderMode::kHeigl;
    const auto refuse = [&](const std::string& what) {
        throw Error(ErrorKind::kUsage, "E-RENDER-REFERENCE",
                    name_of(options.mode) + " in plain code: " + what, "leave out --reference");
    };
    if (options.supersample) refuse("one sample a pixel is drawn, not four");
    if (options.debug_picture == DebugPicture::kGrid) refuse("there is no grid to show");
    if (!draws_rays && options.debug_picture != DebugPicture::kNone)
        refuse("triangles are drawn without debug pictures");
}

}  // namespace

Frame draw_mode_reference(const Lumigraph& lumigraph, const Eye& eye,
                          const RenderOptions& options) {
    expect_drawable(options);
    if (lacks_depth(lumigraph))
        return draw_mode_reference(with_depth_of_others(lumigraph), eye, options);
    switch (options.mode) {
        case RenderMode::kAdaptive:
            return draw_adaptive(lumigraph, eye, options);
        case RenderMode::kPaper2001:
            return draw_paper2001(lumigraph, eye, options);
        case RenderMode::kHeigl:
            return draw_reference(lumigraph, eye, options, heigl_polygons(lumigraph, eye));
        default:
            return draw_reference(lumigraph, eye, options);
    }
}

}  // namespace lumi
