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

    /// Over all that was in the layers; what is nearer than `max_inverse_depth` says is left out.
    /// Leaves another framebuffer bound, and the depth test and face culling off.
    void draw(const Eye& eye, const std::vector<DepthLayerDraw>& draws, double max_inverse_depth,
              const TextureArray& layers);

 private:
    void clear(const TextureArray& layers);
    void aim_at_view(const Eye& eye, int view_index, double max_inverse_depth) const;

    const std::vector<LumigraphView>& views_;
    Program program_;
    std::vector<VertexBuffer> meshes_;
    Framebuffer framebuffer_;
};

}  // namespace lumi
