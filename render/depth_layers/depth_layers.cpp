#include "render/depth_layers/depth_layers.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "calib/work/parallel_for.h"
#include "render/depth_layers/depth_kind_ranges.h"
#include "render/depth_layers/depth_reach.h"
#include "render/depth_layers/lone_surfaces.h"
#include "render/depth_mesh/view_depth_mesh.h"
#include "render/gl/capabilities.h"

namespace lumi {
namespace {

/// Beyond what can be reached, so that rounding clips nothing.
constexpr double kHeadroom = 2.0;

std::vector<std::shared_ptr<const DepthMesh>> meshes_of(const UploadedLumigraph& uploaded) {
    const std::vector<LumigraphView>& views = uploaded.layout.views;
    const DepthMeshOptions options = depth_mesh_options(uploaded.layout);
    std::vector<std::shared_ptr<const DepthMesh>> meshes(views.size());
    parallel_for(static_cast<int>(views.size()), 0, [&](int i) {
        const auto view = static_cast<std::size_t>(i);
        meshes[view] = depth_mesh_of(
            views[view], max_disparity_px(uploaded.searched_views.geometries[view]), options);
    });
    return meshes;
}

}  // namespace

DepthLayers::DrawnBy DepthLayers::usually_drawn_by() {
    return query_capabilities().works_on_cpu ? DrawnBy::kCores : DrawnBy::kOpenGl;
}

DepthLayers::DepthLayers(const UploadedLumigraph& uploaded, int layers, DrawnBy drawn_by)
    : uploaded_(uploaded),
      max_inverse_depth_(nearest_inverse_depth(uploaded.layout)),
      layer_count_(layers) {
    auto meshes = meshes_of(uploaded);
    for (const auto& mesh : meshes) {
        kind_begins_.push_back(mesh->kind_begin);
        mesh_boxes_.push_back(box_of(*mesh));
    }
    const std::vector<LumigraphView>& views = uploaded.layout.views;
    if (drawn_by == DrawnBy::kCores)
        rasters_.emplace(views, std::move(meshes));
    else
        painter_.emplace(views, meshes);
}

double DepthLayers::max_inverse_depth_of(const Eye& eye, const std::vector<DepthViewSet>& sets,
                                         double agreeing) const {
    const double usual = nearest_inverse_depth(uploaded_.layout);
    double reach = 0;
    for (const DepthViewSet& set : sets) {
        for (const int index : set.view_indices) {
            const auto view = static_cast<std::size_t>(index);
            reach =
                std::max(reach, depth_reach(uploaded_.layout.views[view], mesh_boxes_[view], eye));
        }
    }
    if (reach == 0) return usual;
    // What agrees must still fit between two kinds.
    return std::min(usual,
                    std::max(kHeadroom * reach, kDepthKindWidth / kMostAgreeingDepth * agreeing));
}

void DepthLayers::resize(int width_px, int height_px) {
    const int layers = is_packed() ? 1 : layer_count_;
    if (layers_.width_px() == width_px && layers_.height_px() == height_px &&
        layers_.layers() == layers)
        return;
    const TexelFormat format = is_packed() ? TexelFormat::kFourFloats : TexelFormat::kDepth;
    layers_ = TextureArray(format, TexelFilter::kNearest, width_px, height_px, layers);
}

void DepthLayers::draw(const Eye& eye, const std::vector<DepthViewSet>& sets) {
    const Camera& camera = eye.camera;
    resize(camera.width_px, camera.height_px);
    const std::vector<DepthLayerDraw> draws =
        depth_layer_draws(sets, layer_count_, camera.width_px, kind_begins_);
    const double agreeing =
        agreeing_in_layers(uploaded_.layout, uploaded_.searched_views.geometries, sets,
                           centre_in_world(eye.cam_from_world));
    max_inverse_depth_ = max_inverse_depth_of(eye, sets, agreeing);
    agreeing_depth_ = static_cast<float>(kDepthKindWidth * agreeing / max_inverse_depth_);
    if (!is_packed())
        return painter_->draw(eye, draws, max_inverse_depth_, agreeing_depth_, layers_);
    std::vector<float>& packed =
        rasters_->draw(eye, draws, max_inverse_depth_, agreeing_depth_, layer_count_);
    settle_lone_surfaces(uploaded_.layout.views, eye, sets, layer_count_, max_inverse_depth_,
                         agreeing_depth_, packed);
    layers_.upload(packed);
}

}  // namespace lumi
