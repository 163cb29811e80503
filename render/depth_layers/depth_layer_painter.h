#pragma once

#include <memory>
#include <vector>

#include "render/depth_layers/depth_eye.h"
#include "render/depth_layers/depth_layer_draws.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/gl/vertex_buffer.h"
#include "render/lumigraph/lumigraph.h"
#include "render/transfer/view_geometry.h"

namespace lumi {

/// Draws views' depth meshes into layers of a depth texture.
class DepthLayerPainter {
 public:
    /// Uploads the meshes, one for each of the views, which must stay.
    DepthLayerPainter(const std::vector<LumigraphView>& views,
                      const std::vector<std::shared_ptr<const DepthMesh>>& meshes);

    /// Over all that was in the layers; what is nearer than `max_inverse_depth` says is left out,
    /// what lies behind tears by more than `agreeing_depth`, in units of the depth buffer, is
    /// marked (behind_tears.h). Leaves another framebuffer bound, and the depth test and face
    /// culling off.
    void draw(const Eye& eye, const std::vector<DepthLayerDraw>& draws, double max_inverse_depth,
              float agreeing_depth, const TextureArray& layers);

 private:
    /// Draws go to this layer, in which nothing is.
    void begin_layer(const TextureArray& layers, int layer);
    void draw_triangles(const DepthLayerDraw& draw, const Eye& eye, double max_inverse_depth,
                        const Program& program) const;
    [[nodiscard]] Eigen::Matrix4d clip_from_view_pixel(const Eye& eye, int view_index,
                                                       double max_inverse_depth) const;

    const std::vector<LumigraphView>& views_;
    Program program_;
    Program seen_program_;    ///< Marks what lies behind what is in `stretched_`.
    TextureArray stretched_;  ///< What one view stretches over tears.
    std::vector<VertexBuffer> meshes_;
    Framebuffer framebuffer_;
};

}  // namespace lumi
