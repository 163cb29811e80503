#include "render/depth_layers/depth_layer_rasters.h"

#include <algorithm>
#include <utility>

#include "calib/capture/inverse_depth_warp.h"
#include "calib/work/parallel_for.h"
#include "render/depth_layers/behind_tears.h"
#include "render/depth_layers/depth_kind_ranges.h"

namespace lumi {
namespace {

/// A thread transforms so many vertices at a time.
constexpr std::size_t kVerticesAtATime = 4096;
/// Those that a thread packs at a time stay in its cache.
constexpr std::size_t kTexelsAtATime = 4096;
/// Tasks for each core, so that none waits long for the others at the end.
constexpr int kTasksACore = 3;
/// Each band of a layer looks at all of its triangles: more of them take longer than they save.
constexpr int kMostBands = 8;

/// Of each of so many layers.
int bands_of(int layers) {
    return std::clamp(kTasksACore * resolve_threads(0) / std::max(1, layers), 1, kMostBands);
}

/// (x, y, 1, inverse depth) in the view to (X, Y, W, depth * W) in the eye's window.
Eigen::Matrix4f window_from_view(const Eye& eye, const LumigraphView& view,
                                 double max_inverse_depth) {
    const InverseDepthWarp eye_from_view = warp_from(view).to(eye);
    Eigen::Matrix<double, 3, 4> pixel;
    pixel << eye_from_view.infinite_homography, eye_from_view.epipole;
    Eigen::Matrix4d window;
    window.row(0) = pixel.row(0);
    window.row(1) = eye.camera.height_px * pixel.row(2) - pixel.row(1);
    window.row(2) = pixel.row(2);
    window.row(3) = pixel.row(2) - Eigen::RowVector4d(0, 0, 0, 1 / max_inverse_depth);
    return window.cast<float>();
}

}  // namespace

DepthLayerRasters::DepthLayerRasters(const std::vector<LumigraphView>& views,
                                     std::vector<std::shared_ptr<const DepthMesh>> meshes)
    : views_(views), meshes_(std::move(meshes)) {}

std::vector<float>& DepthLayerRasters::draw(const Eye& eye,
                                            const std::vector<DepthLayerDraw>& draws,
                                            double max_inverse_depth, float agreeing_depth,
                                            int layers) {
    aim(eye, draws, max_inverse_depth);
    const int width = eye.camera.width_px;
    const int height = eye.camera.height_px;
    const std::size_t texels_a_layer =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    texels_.resize(static_cast<std::size_t>(layers) * texels_a_layer);
    stretched_.resize(texels_.size());
    const int bands = bands_of(layers);
    parallel_for(layers * bands, 0, [&](int task) {
        const int layer = task / bands;
        const int band = task % bands;
        const DepthBufferBox box{0, band * height / bands, width, (band + 1) * height / bands};
        const auto layer_of = [&](std::vector<float>& all) {
            return DepthBuffer{
                std::span(all).subspan(static_cast<std::size_t>(layer) * texels_a_layer,
                                       texels_a_layer),
                width};
        };
        draw_layer(layer, draws, box, layer_of(texels_), layer_of(stretched_), agreeing_depth);
    });
    pack(layers, texels_a_layer);
    return packed_;
}

void DepthLayerRasters::draw_layer(int layer, const std::vector<DepthLayerDraw>& draws,
                                   const DepthBufferBox& band, const DepthBuffer& known,
                                   const DepthBuffer& stretched, float agreeing_depth) const {
    const auto in_band = [&](const DepthBuffer& buffer) {
        return buffer.texels.subspan(
            static_cast<std::size_t>(band.begin_y * buffer.width),
            static_cast<std::size_t>((band.end_y - band.begin_y) * buffer.width));
    };
    constexpr float kNothing = 1.0F;
    std::ranges::fill(in_band(known), kNothing);
    std::ranges::fill(in_band(stretched), kNothing);
    for (const DepthLayerDraw& draw : draws) {
        const bool is_stretched = draw.kind == static_cast<int>(DepthKind::kStretched);
        if (draw.layer == layer) draw_band(draw, band, is_stretched ? stretched : known);
    }
    lay_before_tears(in_band(known), in_band(stretched), agreeing_depth);
}

void DepthLayerRasters::pack(int layers, std::size_t texels_a_layer) {
    const auto components = static_cast<std::size_t>(kPacked);
    const std::size_t size = texels_a_layer * components;
    // Of layers that are not asked for something is left where they were asked for before.
    if (packed_.size() != size || packed_layers_ != layers) packed_.assign(size, 1.0F);
    packed_layers_ = layers;
    parallel_for_runs(texels_a_layer, kTexelsAtATime, 0, [&](std::size_t first, std::size_t end) {
        for (std::size_t layer = 0; layer < static_cast<std::size_t>(layers); ++layer)
            for (std::size_t i = first; i < end; ++i)
                packed_[i * components + layer] = texels_[layer * texels_a_layer + i];
    });
}

/// Transforms the vertices of all meshes that are drawn.
void DepthLayerRasters::aim(const Eye& eye, const std::vector<DepthLayerDraw>& draws,
                            double max_inverse_depth) {
    struct Run {
        const DepthMesh* mesh;
        AimedMesh* aimed;
        std::size_t first;
    };
    std::vector<Run> runs;
    aimed_.clear();
    for (const DepthLayerDraw& draw : draws) {
        const auto [found, is_new] = aimed_.try_emplace(draw.view_index);
        if (!is_new) continue;
        const auto view = static_cast<std::size_t>(draw.view_index);
        AimedMesh& aimed = found->second;
        aimed.window_from_view = window_from_view(eye, views_[view], max_inverse_depth);
        const DepthMesh& mesh = *meshes_[view];
        aimed.in_window.resize(mesh.vertices.size());
        for (std::size_t first = 0; first < mesh.vertices.size(); first += kVerticesAtATime)
            runs.push_back({&mesh, &aimed, first});
    }
    parallel_for(static_cast<int>(runs.size()), 0, [&](int i) {
        const auto& [mesh, aimed, first] = runs[static_cast<std::size_t>(i)];
        const std::size_t end = std::min(first + kVerticesAtATime, mesh->vertices.size());
        for (std::size_t vertex = first; vertex < end; ++vertex)
            aimed->in_window[vertex] =
                window_vertex(aimed->window_from_view, mesh->vertices[vertex]);
    });
}

void DepthLayerRasters::draw_band(const DepthLayerDraw& draw, const DepthBufferBox& band,
                                  const DepthBuffer& buffer) const {
    const DepthMesh& mesh = *meshes_[static_cast<std::size_t>(draw.view_index)];
    const AimedMesh& aimed = aimed_.at(draw.view_index);
    const DepthBufferBox box{draw.strip_begin_px, band.begin_y, draw.strip_end_px, band.end_y};
    draw_depth_triangles({mesh.vertices, mesh.indices, aimed.in_window, aimed.window_from_view},
                         draw.first_index, draw.index_count,
                         static_cast<float>(kDepthKindStep * draw.kind),
                         static_cast<float>(kDepthKindWidth), box, buffer);
}

}  // namespace lumi
