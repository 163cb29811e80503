#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "render/depth_layers/depth_eye.h"
#include "render/depth_layers/depth_layers.h"
#include "render/frame/drawing_mode.h"
#include "render/painters/blend_painter.h"
#include "render/painters/face_painter.h"
#include "render/painters/grid_painter.h"
#include "render/painters/hole_finder.h"
#include "render/painters/picture_program.h"
#include "render/painters/pixel_blocks.h"
#include "render/painters/surroundings_painter.h"
#include "render/subdivision/adaptive_subdivision.h"

namespace lumi {

/// Depth, weights and visibility at each pixel: first the depth maps of the views nearest to the
/// eye are drawn, each into a layer; then each face blends its three photographs at the depth that
/// the layers agree on, with the paper's occlusion correction (section 4): views whose depth was
/// drawn see what their layers show, of others the depth maps tell. Shells over close-ups are laid
/// over that. The cost does not depend on the scene.
///
/// Where photographs cannot tell the difference, all but the colours is worked out for blocks of
/// two by two pixels (DrawingChoices::depth_block_px), at two thirds of the cost, about. Where they
/// can, and depth is sampled finely enough, silhouettes are smooth.
///
/// Where photographs can tell (DrawingChoices::fills_holes), what none of the views that were asked
/// for depth sees is drawn from others (hole_triangles.h).
class PerPixel : public DrawingMode {
 public:
    explicit PerPixel(const UploadedLumigraph& uploaded,
                      DepthLayers::DrawnBy depth_drawn_by = DepthLayers::usually_drawn_by());
    DrawStatistics draw(const Eye& eye, const RenderOptions& options,
                        const Viewport& viewport) override;

 private:
    /// Which views are asked for depth, and where.
    struct AskedDepth {
        std::vector<DepthViewSet> sets;
        DepthEye depth_eye;
        PictureCells holes;  ///< That are to be filled.
    };
    /// What fragments stand for: the pixels of a viewport, or blocks of them (pixel_blocks.h).
    struct Fragments {
        Viewport viewport;
        int rows_below_px = 0;  ///< Of the lowest fragments, beyond the picture.
        int side_px = 1;
    };

    /// Indexed by how many of a face's views are not asked for depth, 0 to 3: their depth maps are
    /// looked up, what the others see their layers tell.
    using Programs = std::array<PictureProgram, 4>;
    /// How many layers of depth there are, and how they lie in the texture.
    [[nodiscard]] std::vector<std::string> layer_definitions() const;
    [[nodiscard]] Programs programs(const std::vector<std::string>& definitions) const;
    enum class Fade { kNone, kBeyondCapture, kShell };

    /// The faces of the camera mesh, and the triangles that they take.
    std::size_t draw_base(const Eye& eye, const RenderOptions& options, const Viewport& viewport,
                          const AskedDepth& asked);
    /// The cells of the picture that surroundings are drawn in, beneath the faces.
    [[nodiscard]] PictureCells open_cells(const std::vector<FacePolygon>& polygons, const Eye& eye,
                                          const RenderOptions& options) const;
    /// What no view that was asked for depth sees: found once depth was drawn, then drawn from
    /// others.
    [[nodiscard]] PictureCells found_holes(const DepthEye& depth_eye, const Camera& camera);
    std::size_t fill_holes(const Eye& eye, const RenderOptions& options, const AskedDepth& asked);
    std::size_t draw_shells(const Eye& eye, const RenderOptions& options, const Viewport& viewport,
                            const AskedDepth& asked);
    /// Puts the program in use, with all that they need.
    const Program& use(PictureProgram& picture, const Eye& eye, const RenderOptions& options,
                       const Fragments& fragments, const AskedDepth& asked);
    /// The faces in the strip of each set, with its views.
    std::size_t draw_strips(const std::vector<FacePolygon>& polygons, const Eye& eye,
                            const RenderOptions& options, const Fragments& fragments,
                            const AskedDepth& asked, Fade fade);
    /// The uploaded faces, whose first views are the layers'.
    std::size_t draw_faces(const Eye& eye, const RenderOptions& options, const Fragments& fragments,
                           const AskedDepth& asked, Fade fade, const std::vector<int>& layer_views);

    const UploadedLumigraph& uploaded_;
    SurroundingsPainter surroundings_;
    int layer_count_;
    DepthLayers depth_;
    FacePainter faces_;
    BlendPainter blend_;
    std::optional<HoleFinder> holes_;  ///< When it is first asked for.
    AdaptiveSubdivider subdivider_;
    GridPainter grid_;
    PixelBlocks blocks_;
    Programs in_pixels_;
    Programs smooth_;  ///< The same with smooth silhouettes (DepthEye).
    Programs in_blocks_;
    Programs fading_;  ///< For shells, and for what fades beyond the capture.
};

}  // namespace lumi
