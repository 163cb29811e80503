#include "render/reference/reference_renderer.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "calib/capture/nearest_byte.h"
#include "render/reference/reference_blend.h"
#include "render/reference/reference_holes.h"
#include "render/surroundings/surroundings.h"

namespace lumi {
namespace {

/// The frame in the making, and what does not change from pixel to pixel.
class ReferenceFrame {
 public:
    ReferenceFrame(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options,
                   const std::optional<std::vector<FacePolygon>>& polygons);
    [[nodiscard]] DrawnPixel color_at(int x, int y) const;

 private:
    /// The mean of all that is drawn for a pixel.
    [[nodiscard]] std::optional<DrawnPixel> base_at(const std::vector<KnownPoint>& shared,
                                                    const Eigen::Vector2d& pixel) const;
    /// Where nothing is seen.
    [[nodiscard]] DrawnPixel behind(int x, int y) const;
    /// What is not known is drawn from other views, if these know it.
    void fill(DrawnPixel& drawn, int x, int y) const;

    const Lumigraph& lumigraph_;
    const RenderOptions& options_;
    ReferenceBlend blend_;
    ColorImage surroundings_;      ///< Empty where they are not drawn.
    std::optional<Frame> filled_;  ///< None where holes are not filled.
};

ReferenceFrame::ReferenceFrame(const Lumigraph& lumigraph, const Eye& eye,
                               const RenderOptions& options,
                               const std::optional<std::vector<FacePolygon>>& polygons)
    : lumigraph_(lumigraph),
      options_(options),
      blend_(lumigraph, eye, options, polygons),
      surroundings_(
          are_surroundings_drawn(options)
              ? surroundings_picture(lumigraph, eye, blend_.is_in_blocks() ? kDepthBlockSide_px : 1)
              : ColorImage{}) {
    const std::optional<AgreedDepth>& depth = blend_.points().depth();
    if (depth && lumigraph.drawing.fills_holes && !options.fade_beyond_capture)
        filled_ = filled_holes(lumigraph, *depth, eye, options);
}

std::optional<DrawnPixel> ReferenceFrame::base_at(const std::vector<KnownPoint>& shared,
                                                  const Eigen::Vector2d& pixel) const {
    if (shared.size() == 1) return blend_.at(shared.front(), pixel);
    DrawnPixel sum;
    double count = 0;
    for (const KnownPoint& known : shared) {
        const std::optional<DrawnPixel> drawn = blend_.at(known, pixel);
        if (!drawn) continue;
        sum.color += drawn->color;
        sum.coverage += drawn->coverage;
        ++count;
    }
    if (count == 0) return std::nullopt;
    return DrawnPixel{sum.color / count, sum.coverage >= 0.5 * count ? 1.0 : 0.0};
}

DrawnPixel ReferenceFrame::color_at(int x, int y) const {
    const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
    const Eigen::Vector2d block(x / kDepthBlockSide_px, y / kDepthBlockSide_px);
    const std::vector<KnownPoint> known = blend_.points().at(pixel);
    DrawnPixel drawn =
        base_at(blend_.is_in_blocks() ? blend_.points().at(kDepthBlockSide_px *
                                                           (block + Eigen::Vector2d::Constant(0.5)))
                                      : known,
                pixel)
            .value_or(behind(x, y));
    fill(drawn, x, y);
    // What the paper of heigl says has none.
    if (options_.mode == RenderMode::kHeigl) return drawn;
    for (const CameraMesh& shell : lumigraph_.mesh.shells)
        blend_.lay_over(drawn, shell, known.front());
    return drawn;
}

DrawnPixel ReferenceFrame::behind(int x, int y) const {
    DrawnPixel drawn;
    if (surroundings_.empty()) return drawn;
    const Rgb8& color = surroundings_(x, y);
    drawn.color = {static_cast<double>(color.r), static_cast<double>(color.g),
                   static_cast<double>(color.b)};
    return drawn;
}

void ReferenceFrame::fill(DrawnPixel& drawn, int x, int y) const {
    if (!filled_ || filled_->coverage(x, y) == 0) return;
    // White among the weights: none of those that should see it does.
    const Rgb8 color = options_.debug_picture == DebugPicture::kWeights ? Rgb8{255, 255, 255}
                                                                        : filled_->color(x, y);
    drawn.color = (1 - drawn.coverage) * Eigen::Vector3d(color.r, color.g, color.b) +
                  drawn.coverage * drawn.color;
    drawn.coverage = std::max(drawn.coverage, filled_->coverage(x, y) / 255.0);
}

}  // namespace

Frame draw_reference(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options,
                     const std::optional<std::vector<FacePolygon>>& polygons) {
    const ReferenceFrame reference(lumigraph, eye, options, polygons);
    Frame frame = empty_frame(eye.camera);
    for (int y = 0; y < eye.camera.height_px; ++y) {
        for (int x = 0; x < eye.camera.width_px; ++x) {
            const DrawnPixel drawn = reference.color_at(x, y);
            const Eigen::Vector3d& color = drawn.color;
            frame.color(x, y) = {nearest_byte(color.x()), nearest_byte(color.y()),
                                 nearest_byte(color.z())};
            frame.coverage(x, y) = nearest_byte(255 * drawn.coverage);
        }
    }
    return frame;
}

}  // namespace lumi
