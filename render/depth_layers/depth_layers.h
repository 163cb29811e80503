#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "render/depth_layers/depth_layer_painter.h"
#include "render/depth_layers/depth_layer_rasters.h"
#include "render/uploaded/uploaded_lumigraph.h"

namespace lumi {

/// Depth maps of views as the eye sees them: one layer of a depth texture a view.
///
/// A layer holds the nearest surface of the most reliable kind: each kind is drawn into a range of
/// the depth buffer of its own, so that the depth test prefers what was seen to what was filled,
/// and either to what is stretched over a tear, near or far. Surfaces seen from behind are not
/// drawn. What was seen, but lies behind what the view stretches, is marked (behind_tears.h). In
/// layers that are packed lone surfaces are settled (lone_surfaces.h); in others
/// shaders/lone_surfaces.glsl settles them.
///
/// Where OpenGL works on the CPU they are drawn in memory (DepthLayerRasters) and handed to it,
/// several in a texel, and else by OpenGL (DepthLayerPainter).
class DepthLayers {
 public:
    enum class DrawnBy { kOpenGl, kCores };
    [[nodiscard]] static DrawnBy usually_drawn_by();

    /// Uploads the depth meshes of all views where OpenGL is to draw them; those that the package
    /// lacks are made, on all cores.
    DepthLayers(const UploadedLumigraph& uploaded, int layers,
                DrawnBy drawn_by = usually_drawn_by());

    /// Draws the layers, in the strip of each set (strip_ends) those of its views. The
    /// layers get the size of the eye's picture. Leaves another framebuffer bound, and the depth
    /// test and face culling off.
    void draw(const Eye& eye, const std::vector<DepthViewSet>& sets);

    /// Layer by layer; or packed: the layers are the components of a texel.
    [[nodiscard]] const TextureArray& texture() const { return layers_; }
    [[nodiscard]] bool is_packed() const { return rasters_.has_value(); }
    /// 1 / (nearest depth that can be drawn for the eye): nearest_inverse_depth, or if that is less
    /// little more than what the sets' depth meshes reach, so that layers tell apart what they can.
    [[nodiscard]] double max_inverse_depth() const { return max_inverse_depth_; }
    /// What depths of one surface may differ by (agreeing_in_layers), in units of the depth buffer.
    [[nodiscard]] float agreeing_depth() const { return agreeing_depth_; }

 private:
    void resize(int width_px, int height_px);
    /// `agreeing`: as from agreeing_in_layers.
    [[nodiscard]] double max_inverse_depth_of(const Eye& eye, const std::vector<DepthViewSet>& sets,
                                              double agreeing) const;

    const UploadedLumigraph& uploaded_;
    double max_inverse_depth_ = 1.0;
    std::vector<DepthKindBegins> kind_begins_;
    std::vector<Eigen::AlignedBox3d> mesh_boxes_;  ///< One for each view (depth_reach.h).
    int layer_count_ = 0;
    float agreeing_depth_ = 0.0F;
    TextureArray layers_;
    /// One of the two.
    std::optional<DepthLayerPainter> painter_;
    std::optional<DepthLayerRasters> rasters_;
};

}  // namespace lumi
