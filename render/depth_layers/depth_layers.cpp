#include "render/depth_layers/depth_layers.h"

#include <algorithm>

#include "calib/work/parallel_for.h"
#include "render/depth_mesh/view_depth_mesh.h"

namespace lumi {
namespace {

/// The scene's near end lies this many times beyond the nearest that an eye can look at.
constexpr double kNearMargin = 100.0;

/// So many meshes are made before they are uploaded: more of them only take memory.
constexpr std::size_t kMeshesAtOnce = 16;

/// More threads would have less than a view each to draw.
constexpr int kMostThreads = 4;

/// Of the views from `first`, at most kMeshesAtOnce.
std::vector<std::shared_ptr<const DepthMesh>> some_meshes(const UploadedLumigraph& uploaded,
                                                          std::size_t first) {
    const std::vector<LumigraphView>& views = uploaded.layout.views;
    std::vector<std::shared_ptr<const DepthMesh>> meshes(
        std::min(kMeshesAtOnce, views.size() - first));
    parallel_for(static_cast<int>(meshes.size()), 0, [&](int i) {
        const auto offset = static_cast<std::size_t>(i);
        meshes[offset] =
            depth_mesh_of(views[first + offset],
                          max_disparity_px(uploaded.searched_views.geometries[first + offset]));
    });
    return meshes;
}

}  // namespace

DepthLayers::DepthLayers(const UploadedLumigraph& uploaded, int layers)
    : max_inverse_depth_(kNearMargin * inverse_depth_range(uploaded.layout).y()),
      layer_count_(layers),
      threads_(kMostThreads),
      painters_(threads_.size()) {
    upload_meshes(uploaded);
    threads_.run([&](std::size_t thread) {
        painters_[thread] =
            std::make_unique<DepthLayerPainter>(uploaded.layout.views, meshes_, max_inverse_depth_);
    });
}

void DepthLayers::upload_meshes(const UploadedLumigraph& uploaded) {
    static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
    while (meshes_.size() < uploaded.layout.views.size()) {
        for (const auto& mesh : some_meshes(uploaded, meshes_.size())) {
            meshes_.emplace_back(std::vector<VertexAttribute>{{0, 3}});
            meshes_.back().upload(mesh->vertices.data(),
                                  mesh->vertices.size() * sizeof(Eigen::Vector3f), mesh->indices);
            kind_begins_.push_back(mesh->kind_begin);
        }
    }
}

DepthLayers::~DepthLayers() {
    threads_.run([&](std::size_t thread) { painters_[thread].reset(); });
}

double DepthLayers::buffer_difference(double inverse_depth_difference) const {
    return std::min(kDepthKindWidth * inverse_depth_difference / max_inverse_depth_,
                    0.5 * (kDepthKindStep - kDepthKindWidth));
}

void DepthLayers::resize(int width_px, int height_px, int layers) {
    if (layers_.width_px() == width_px && layers_.height_px() == height_px &&
        layers_.layers() == layers)
        return;
    layers_ = TextureArray(TexelFormat::kDepth, TexelFilter::kNearest, width_px, height_px, layers);
}

void DepthLayers::draw(const DepthEye& depth_eye, const std::vector<DepthViewSet>& sets) {
    const Camera& camera = depth_eye.eye.camera;
    resize(camera.width_px, camera.height_px, depth_eye.samples * layer_count_);
    const std::vector<DepthLayerDraw> draws =
        depth_layer_draws(sets, layer_count_, depth_eye.samples, camera.width_px, kind_begins_);
    const auto parts = in_even_parts(draws, threads_.size());
    painters_.front()->clear(layers_);
    threads_.run(
        [&](std::size_t thread) { painters_[thread]->draw(depth_eye, parts[thread], layers_); });
}

}  // namespace lumi
