#pragma once

#include <optional>
#include <vector>

#include "render/frame/drawing_mode.h"
#include "render/painters/blend_painter.h"
#include "render/painters/surroundings_painter.h"
#include "render/subdivision/adaptive_subdivision.h"

namespace lumi {

/// The triangles of the mode `adaptive` for one eye: layers, each to be laid over those before it
/// with its opacity: those of the camera mesh; where there are any, parts that other views see
/// (seen_parts.h; not of guesses) and what is thin (thin_triangles.h), neither where the capture's
/// border fades; those of each shell of the mesh. `views` are the layout's. `subdivider` lends
/// nothing but its memory.
[[nodiscard]] std::vector<BlendTriangles> adaptive_layers(const Lumigraph& layout,
                                                          const SearchedViews& views,
                                                          const Eye& eye,
                                                          const RenderOptions& options,
                                                          AdaptiveSubdivider& subdivider);
/// The same with a subdivider of its own.
[[nodiscard]] std::vector<BlendTriangles> adaptive_layers(const Lumigraph& layout,
                                                          const SearchedViews& views,
                                                          const Eye& eye,
                                                          const RenderOptions& options);

/// Adaptive depth correction by the error in pixels (adaptive_subdivision.h), with occlusion
/// correction at the vertices, in one pass. While the eye stands still the triangles stay; when it
/// moves they are made anew, so that no frame depends on how the eye came there.
class Adaptive : public DrawingMode {
 public:
    explicit Adaptive(const UploadedLumigraph& uploaded);
    DrawStatistics draw(const Eye& eye, const RenderOptions& options,
                        const Viewport& viewport) override;
    void forget_frame() override { made_for_.reset(); }

 private:
    /// What layers of triangles were made for.
    struct Request {
        Eye eye;
        RenderOptions options;
    };
    void draw_surroundings(const Eye& eye, const RenderOptions& options);
    [[nodiscard]] bool is_made_for(const Eye& eye, const RenderOptions& options) const;

    const UploadedLumigraph& uploaded_;
    SurroundingsPainter surroundings_;
    BlendPainter blend_;
    AdaptiveSubdivider subdivider_;
    std::optional<Request> made_for_;
    std::vector<BlendTriangles> layers_;
};

}  // namespace lumi
