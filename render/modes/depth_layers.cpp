#include "render/modes/depth_layers.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "calib/work/parallel_for.h"
#include "render/gl/to_glm.h"
#include "render/modes/pixel_transfer.h"
#include "render/modes/view_depth_mesh.h"
#include "render/shaders/shader_sources.h"

namespace lumi {
namespace {

/// The scene's near end lies this many times beyond the nearest that an eye can look at.
constexpr double kNearMargin = 100.0;

/// So many meshes are made before they are uploaded: more of them only take memory.
constexpr std::size_t kMeshesAtOnce = 16;

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
    : uploaded_(uploaded),
      layer_count_(layers),
      max_inverse_depth_(kNearMargin * inverse_depth_range(uploaded.layout).y()),
      program_("depth_layer", {shader_source("depth_layer")}) {
    static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
    while (meshes_.size() < uploaded.layout.views.size()) {
        for (const auto& mesh : some_meshes(uploaded, meshes_.size())) {
            ViewMesh& view = meshes_.emplace_back();
            view.triangles = VertexBuffer({{0, 3}});
            view.triangles.upload(mesh->vertices.data(),
                                  mesh->vertices.size() * sizeof(Eigen::Vector3f), mesh->indices);
            view.kind_begin = mesh->kind_begin;
        }
    }
}

double DepthLayers::buffer_difference(double inverse_depth_difference) const {
    return std::min(kDepthKindWidth * inverse_depth_difference / max_inverse_depth_,
                    0.5 * (kDepthKindStep - kDepthKindWidth));
}

void DepthLayers::resize(int width_px, int height_px) {
    if (layers_.width_px() == width_px && layers_.height_px() == height_px) return;
    layers_ =
        TextureArray(TexelFormat::kDepth, TexelFilter::kNearest, width_px, height_px, layer_count_);
}

void DepthLayers::draw(const Eye& eye, const std::vector<DepthViewSet>& sets) {
    resize(eye.camera.width_px, eye.camera.height_px);
    glViewport(0, 0, eye.camera.width_px, eye.camera.height_px);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glClearDepthf(1.0F);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    program_.use();
    const std::vector<int> ends = strip_ends(sets, eye.camera.width_px);
    const DepthLayerViews views = depth_layer_views(sets, layer_count_);
    for (int layer = 0; layer < layer_count_; ++layer) {
        framebuffer_.attach_depth_layer(layers_, layer);
        glDepthRangef(0.0F, 1.0F);
        glClear(GL_DEPTH_BUFFER_BIT);
        draw_strips(eye, ends, views, static_cast<std::size_t>(layer));
    }
    glDepthRangef(0.0F, 1.0F);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

void DepthLayers::draw_strips(const Eye& eye, const std::vector<int>& ends,
                              const DepthLayerViews& views, std::size_t layer) const {
    glEnable(GL_SCISSOR_TEST);
    int begin = 0;
    for (std::size_t set = 0; set < ends.size(); ++set) {
        const int view = views[set][layer];
        const bool goes_on = set + 1 < ends.size() && views[set + 1][layer] == view;
        if (goes_on) continue;
        glScissor(begin, 0, ends[set] - begin, eye.camera.height_px);
        if (view != kNoView && begin < ends[set]) draw_view(eye, view);
        begin = ends[set];
    }
    glDisable(GL_SCISSOR_TEST);
}

void DepthLayers::draw_view(const Eye& eye, int view_index) const {
    const auto index = static_cast<std::size_t>(view_index);
    const LumigraphView& view = uploaded_.layout.views[index];
    const PixelTransfer eye_from_view =
        pixel_transfer(eye.camera, eye.cam_from_world, view.camera, view.cam_from_world);
    // (x, y, 1, q) of the view to (X, Y, W, q) of the eye.
    Eigen::Matrix4d transfer = Eigen::Matrix4d::Identity();
    transfer.topLeftCorner<3, 3>() = eye_from_view.at_infinity;
    transfer.topRightCorner<3, 1>() = eye_from_view.per_inverse_depth;
    const Eigen::Matrix4d clip =
        clip_from_pixel(eye.camera.width_px, eye.camera.height_px, max_inverse_depth_);
    program_.set("clip_from_view_pixel", to_glm(Eigen::Matrix4d(clip * transfer)));
    const ViewMesh& mesh = meshes_[index];
    for (std::size_t kind = 0; kind < kDepthKinds; ++kind) {
        const double begin = kDepthKindStep * static_cast<double>(kind);
        glDepthRangef(static_cast<float>(begin), static_cast<float>(begin + kDepthKindWidth));
        mesh.triangles.draw(mesh.kind_begin[kind],
                            mesh.kind_begin[kind + 1] - mesh.kind_begin[kind]);
    }
}

}  // namespace lumi
