#include "render/uploaded/uploaded_lumigraph.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>

#include "calib/work/error.h"
#include "calib/work/parallel_for.h"
#include "render/surroundings/surroundings.h"
#include "render/transfer/past_sight.h"
#include "render/uploaded/photograph_lod.h"
#include "render/uploaded/photograph_opacity.h"

namespace lumi {
namespace {

Lumigraph without_photographs(const Lumigraph& lumigraph) {
    Lumigraph layout = without_its_views(lumigraph);
    layout.mesh = lumigraph.mesh;
    for (const LumigraphView& view : lumigraph.views)
        layout.views.push_back({view.name,
                                view.camera,
                                view.cam_from_world,
                                view.exif_orientation,
                                {},
                                view.depth,
                                kNoExposureGain,
                                view.depth_mesh});
    return layout;
}

void require_side_fits(const Capabilities& capabilities, const std::string& what, int side_px) {
    if (side_px <= capabilities.max_texture_size_px) return;
    throw Error(ErrorKind::kResources, "E-GL-LIMIT",
                what + " is " + std::to_string(side_px) + " pixels long, but " +
                    capabilities.description + " holds " +
                    std::to_string(capabilities.max_texture_size_px),
                "make the package with a smaller [capture] max_width_px");
}

/// Throws Error (E-GL-LIMIT) unless the current GL holds the photographs and depth maps.
Capabilities capabilities_for(const Lumigraph& lumigraph) {
    Capabilities capabilities = query_capabilities();
    if (lumigraph.views.size() > static_cast<std::size_t>(capabilities.max_array_layers))
        throw Error(ErrorKind::kResources, "E-GL-LIMIT",
                    std::to_string(lumigraph.views.size()) + " photographs, but " +
                        capabilities.description + " holds " +
                        std::to_string(capabilities.max_array_layers),
                    "make the package with [package] max_views, or use another GL driver");
    for (const LumigraphView& view : lumigraph.views) {
        const FloatImage& inverse_depth = view.depth.inverse_depth;
        require_side_fits(
            capabilities, view.name,
            std::max(view.photograph.width(), view.photograph.height()) + 2 * kGutter_px);
        require_side_fits(capabilities, "the depth map of " + view.name,
                          std::max(inverse_depth.width(), inverse_depth.height()));
    }
    return capabilities;
}

TextureArray upload_photographs(const Lumigraph& lumigraph) {
    const std::vector<LumigraphView>& views = lumigraph.views;
    const std::vector<GrayImage> opacities = photograph_opacities(lumigraph);
    int width = 1;
    int height = 1;
    for (const LumigraphView& view : views) {
        width = std::max(width, view.photograph.width());
        height = std::max(height, view.photograph.height());
    }
    width += 2 * kGutter_px;
    height += 2 * kGutter_px;
    TextureArray array(TexelFormat::kColor, TexelFilter::kLinear, width, height,
                       static_cast<int>(views.size()));
    // A few at a time: GL takes them from one thread, and all at once would be all once more.
    std::vector<std::vector<unsigned char>> layers(static_cast<std::size_t>(resolve_threads(0)));
    for (std::size_t first = 0; first < views.size(); first += layers.size()) {
        const std::size_t count = std::min(layers.size(), views.size() - first);
        parallel_for(static_cast<int>(count), 0, [&](int i) {
            const auto at = static_cast<std::size_t>(i);
            layers[at] = photograph_layer(views[first + at].photograph, opacities[first + at],
                                          width, height);
        });
        for (std::size_t at = 0; at < count; ++at)
            array.upload_rgba(static_cast<int>(first + at), layers[at]);
    }
    return array;
}

/// The last bit of each sample tells whether several views agree on it.
FloatImage with_agreed_marked(const DepthMap& depth) {
    FloatImage marked = depth.inverse_depth;
    for (int y = 0; y < marked.height(); ++y) {
        for (int x = 0; x < marked.width(); ++x) {
            const auto bits = std::bit_cast<std::uint32_t>(marked(x, y));
            const std::uint32_t mark = is_agreed_on(depth, x, y) ? 1 : 0;
            marked(x, y) = std::bit_cast<float>((bits & ~std::uint32_t{1}) | mark);
        }
    }
    return marked;
}

TextureArray upload_depth_maps(const std::vector<LumigraphView>& views) {
    int width = 0;
    int height = 0;
    for (const LumigraphView& view : views) {
        width = std::max(width, view.depth.inverse_depth.width());
        height = std::max(height, view.depth.inverse_depth.height());
    }
    if (width == 0) return {};
    TextureArray array(TexelFormat::kFloat, TexelFilter::kNearest, width, height,
                       static_cast<int>(views.size()));
    // Not 0: a view without depth does not see past anything either (per_pixel.glsl).
    const FloatImage nothing_near(1, 1, std::numeric_limits<float>::min());
    for (std::size_t i = 0; i < views.size(); ++i) {
        array.upload(static_cast<int>(i),
                     views[i].has_depth() ? with_agreed_marked(views[i].depth) : nothing_near);
    }
    return array;
}

}  // namespace

UploadedLumigraph::UploadedLumigraph(const Lumigraph& lumigraph)
    : capabilities(capabilities_for(lumigraph)),
      layout(without_photographs(lumigraph)),
      searched_views(lumi::searched_views(lumigraph)),
      small_photographs(lumi::small_photographs(lumigraph)) {
    photographs = upload_photographs(lumigraph);
    depth_maps = upload_depth_maps(lumigraph.views);
    for (const LumigraphView& view : lumigraph.views)
        depth_sizes_px.emplace_back(view.depth.inverse_depth.width(),
                                    view.depth.inverse_depth.height());
}

void UploadedLumigraph::choose(const DrawingChoices& drawing) {
    if (drawing.draws_thin != layout.drawing.draws_thin)
        searched_views.thin = drawing.draws_thin
                                  ? thin_surfaces_of(layout, searched_views.geometries)
                                  : std::vector<ThinSurfaces>(layout.views.size());
    layout.drawing = drawing;
}

double UploadedLumigraph::lod_of(const Eye& eye, const RenderOptions& options) const {
    // Of four samples a pixel each looks photographs up for the whole of it.
    return photograph_lod(layout, eye, samples_along_pixel(options));
}

void UploadedLumigraph::prepare(const Eye& eye, const RenderOptions& options) {
    if (lod_of(eye, options) > 0) photographs.make_mip_levels();
}

}  // namespace lumi
