#pragma once

#include <memory>
#include <vector>

#include "render/depth_layers/depth_layer_painter.h"
#include "render/gl/drawing_threads.h"
#include "render/uploaded/uploaded_lumigraph.h"

namespace lumi {

/// Depth maps of views as the eye sees them: one layer of a depth texture a view.
///
/// A layer holds the nearest surface of the most reliable kind: each kind is drawn into a range of
/// the depth buffer of its own, so that the depth test prefers what was seen to what was filled,
/// and either to what is stretched over a tear, near or far. Surfaces seen from behind are not
/// drawn.
///
/// Where OpenGL works on the CPU, several threads hand it the triangles (DrawingThreads): there are
/// a hundred thousand of them, and they take longer than the pixels. What is drawn is the same.
class DepthLayers {
 public:
    /// Uploads the depth meshes of all views; those that the package lacks are made, on all cores.
    DepthLayers(const UploadedLumigraph& uploaded, int layers);
    ~DepthLayers();
    DepthLayers(const DepthLayers&) = delete;
    DepthLayers& operator=(const DepthLayers&) = delete;

    /// Draws the layers, in the strip of each set (strip_ends) those of its views; of each sample
    /// of a pixel, one after the other. The layers get the size of the eye's picture. Leaves
    /// another framebuffer bound, and the depth test and face culling off.
    void draw(const DepthEye& depth_eye, const std::vector<DepthViewSet>& sets);

    [[nodiscard]] const TextureArray& texture() const { return layers_; }
    /// 1 / (nearest depth that can be drawn).
    [[nodiscard]] double max_inverse_depth() const { return max_inverse_depth_; }
    /// A difference of inverse depths in units of the depth buffer, but no more than what keeps
    /// kinds apart.
    [[nodiscard]] double buffer_difference(double inverse_depth_difference) const;

 private:
    void upload_meshes(const UploadedLumigraph& uploaded);
    void resize(int width_px, int height_px, int layers);

    double max_inverse_depth_ = 1.0;
    std::vector<VertexBuffer> meshes_;
    std::vector<DepthKindBegins> kind_begins_;
    int layer_count_ = 0;
    TextureArray layers_;
    DrawingThreads threads_;
    std::vector<std::unique_ptr<DepthLayerPainter>> painters_;  ///< Of each thread.
};

}  // namespace lumi
