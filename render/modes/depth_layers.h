#pragma once

#include <array>
#include <vector>

#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gl/vertex_buffer.h"
#include "render/lumigraph/depth_mesh.h"
#include "render/modes/uploaded_lumigraph.h"

namespace lumi {

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

    /// Draws the layers of these views, at most as many as there are layers; the others are empty.
    /// Leaves another framebuffer bound, and the depth test and face culling off.
    void draw(const Eye& eye, const std::vector<int>& view_indices);

    [[nodiscard]] const TextureArray& texture() const { return layers_; }
    /// 1 / (nearest depth that can be drawn): inverse depth at the near end of each kind's range; 0
    /// is at its far end.
    [[nodiscard]] double max_inverse_depth() const { return max_inverse_depth_; }

 private:
    struct ViewMesh {
        VertexBuffer triangles;
        std::array<std::size_t, kDepthKinds + 1> kind_begin{};
    };

    void resize(int width_px, int height_px);
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
