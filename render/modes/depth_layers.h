#pragma once

#include <array>
#include <vector>

#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gl/vertex_buffer.h"
#include "render/lumigraph/depth_mesh.h"
#include "render/modes/depth_layer_views.h"
#include "render/modes/uploaded_lumigraph.h"

namespace lumi {

/// Each kind of depth has a range of the depth buffer of its own: it begins at the step times the
/// kind, and inverse depth falls from DepthLayers::max_inverse_depth to 0 over the width. As in
/// shaders/per_pixel.glsl; 1 is nothing.
inline constexpr double kDepthKindStep = 0.33;
inline constexpr double kDepthKindWidth = 0.32;

/// Depth maps of views as the eye sees them: one layer of a depth texture a view.
///
/// A layer holds the nearest surface of the most reliable kind: each kind is drawn into a range of
/// the depth buffer of its own, so that the depth test prefers what was seen to what was filled,
/// and either to what is stretched over a tear, near or far. Surfaces seen from behind are not
/// drawn.
class DepthLayers {
 public:
    /// Uploads the depth meshes of all views; those that the package lacks are made, on all cores.
    DepthLayers(const UploadedLumigraph& uploaded, int layers);

    /// Draws the layers, in the strip of each set (strip_ends) those of its views.
    /// The layers get the size of the eye's picture.
    /// Leaves another framebuffer bound, and the depth test and face culling off.
    void draw(const Eye& eye, const std::vector<DepthViewSet>& sets);

    [[nodiscard]] const TextureArray& texture() const { return layers_; }
    /// 1 / (nearest depth that can be drawn).
    [[nodiscard]] double max_inverse_depth() const { return max_inverse_depth_; }
    /// A difference of inverse depths in units of the depth buffer, but no more than what keeps
    /// kinds apart.
    [[nodiscard]] double buffer_difference(double inverse_depth_difference) const;

 private:
    struct ViewMesh {
        VertexBuffer triangles;
        std::array<std::size_t, kDepthKinds + 1> kind_begin{};
    };

    void resize(int width_px, int height_px);
    /// One layer: each view in the strips of the sets that have it there.
    void draw_strips(const Eye& eye, const std::vector<int>& ends, const DepthLayerViews& views,
                     std::size_t layer) const;
    void draw_view(const Eye& eye, int view_index) const;

    const UploadedLumigraph& uploaded_;
    int layer_count_ = 0;
    double max_inverse_depth_ = 1.0;
    Program program_;
    std::vector<ViewMesh> meshes_;
    TextureArray layers_;
    Framebuffer framebuffer_;
};

}  // namespace lumi
