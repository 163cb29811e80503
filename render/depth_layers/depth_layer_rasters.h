#pragma once

#include <map>
#include <memory>
#include <vector>

#include "render/depth_layers/depth_layer_draws.h"
#include "render/depth_layers/depth_triangles.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Draws views' depth meshes into layers of depth in memory, on all cores: what DepthLayerPainter
/// has OpenGL do. Where OpenGL works on the CPU this takes a third to two fifths of the time: a
/// hundred thousand triangles of a few texels each, which need neither clipping nor shading.
class DepthLayerRasters {
 public:
    /// `meshes` are one for each of the views; the views must stay.
    DepthLayerRasters(const std::vector<LumigraphView>& views,
                      std::vector<std::shared_ptr<const DepthMesh>> meshes);

    /// The eye's picture, with rows from the bottom: kPacked numbers a texel, of which the first
    /// `layers` are layers, and the others 1. What is nearer than `max_inverse_depth` says is left
    /// out; what lies behind tears by more than `agreeing_depth`, in units of the depth buffer, is
    /// marked (behind_tears.h). What is returned stays until the next call, and may be changed.
    [[nodiscard]] std::vector<float>& draw(const Eye& eye, const std::vector<DepthLayerDraw>& draws,
                                           double max_inverse_depth, float agreeing_depth,
                                           int layers);
    static constexpr int kPacked = kMaxDepthViews;

 private:
    struct AimedMesh {
        Eigen::Matrix4f window_from_view;
        std::vector<WindowVertex> in_window;
    };
    /// The part of a layer that lies in the band: what is known in one buffer, with marks; the
    /// other is needed for them.
    void draw_layer(int layer, const std::vector<DepthLayerDraw>& draws, const DepthBufferBox& band,
                    const DepthBuffer& known, const DepthBuffer& stretched,
                    float agreeing_depth) const;
    void aim(const Eye& eye, const std::vector<DepthLayerDraw>& draws, double max_inverse_depth);
    void pack(int layers, std::size_t texels_a_layer);
    void draw_band(const DepthLayerDraw& draw, const DepthBufferBox& band,
                   const DepthBuffer& buffer) const;

    const std::vector<LumigraphView>& views_;
    std::vector<std::shared_ptr<const DepthMesh>> meshes_;
    std::map<int, AimedMesh> aimed_;  ///< Of each view that is drawn.
    std::vector<float> texels_;       ///< Layer by layer.
    std::vector<float> stretched_;    ///< What is stretched over tears, likewise.
    std::vector<float> packed_;
    int packed_layers_ = 0;
};

}  // namespace lumi
