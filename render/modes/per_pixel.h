#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "render/modes/depth_eye.h"
#include "render/modes/depth_layers.h"
#include "render/modes/drawing_mode.h"
#include "render/modes/face_painter.h"
#include "render/modes/grid_painter.h"
#include "render/modes/picture_program.h"
#include "render/modes/surroundings_painter.h"

namespace lumi {

/// Depth, weights and visibility at each pixel: first the depth maps of the views nearest to the
/// eye are drawn, each into a layer; then each face blends its three photographs at the depth that
/// the layers agree on, with the paper's occlusion correction (section 4). Shells over close-ups
/// are laid over that. The cost does not depend on the scene.
class PerPixel : public DrawingMode {
 public:
    explicit PerPixel(const UploadedLumigraph& uploaded);
    DrawStatistics draw(const Eye& eye, const RenderOptions& options,
                        const Viewport& viewport) override;

 private:
    /// Which views are asked for depth, and where.
    struct AskedDepth {
        std::vector<DepthViewSet> sets;
        DepthEye depth_eye;
    };

    /// Puts the program in use, with all that both of them need.
    const Program& use(PictureProgram& picture, const Eye& eye, const RenderOptions& options,
                       const Viewport& viewport, const AskedDepth& asked);
    void set_layers(const Eye& eye, const RenderOptions& options, const AskedDepth& asked,
                    const Program& program) const;
    void set_layer_views(const Eye& eye, const std::vector<DepthViewSet>& sets,
                         const Program& program) const;
    void append_view(const Eye& eye, int view_index, std::vector<glm::vec4>& rows) const;

    const UploadedLumigraph& uploaded_;
    SurroundingsPainter surroundings_;
    int layer_count_;
    DepthLayers depth_;
    FacePainter faces_;
    GridPainter grid_;
    PictureProgram program_;
    PictureProgram fading_;  ///< For shells, and for what fades beyond the capture.
};

}  // namespace lumi
