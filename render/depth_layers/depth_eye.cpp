#include "render/depth_layers/depth_eye.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "calib/work/median.h"
#include "render/transfer/pixels_per_unit.h"

namespace lumi {
namespace {

/// Texels are given to pixels in steps of an eighth: exact in any arithmetic, and no pixel's centre
/// ever lies between two texels.
constexpr double kSteps = 8.0;
/// Beyond this share of the pixels texels are as many as pixels: fewer save little, and fit neither
/// the pixels nor the samples.
constexpr double kNearlyAll = 0.75;

/// How many samples of the views' pictures come to one side of the eye's pixels, at the scene's
/// centre: those of the view in the middle. `samples_per_view_pixel` tells how many a pixel of a
/// view has; views that have none are not asked. Empty where there are no others, or the eye is at
/// the centre.
template <class SamplesPerViewPixel>
std::optional<double> samples_per_pixel(const Lumigraph& lumigraph, const Eye& eye,
                                        const SamplesPerViewPixel& samples_per_view_pixel) {
    const Eigen::Vector3d& centre = lumigraph.mesh.scene_centre_in_world;
    const double of_eye = pixels_per_unit(eye.camera, eye.cam_from_world, centre);
    std::vector<double> of_views;
    for (const LumigraphView& view : lumigraph.views) {
        const double samples = samples_per_view_pixel(view);
        if (samples > 0)
            of_views.push_back(samples * pixels_per_unit(view.camera, view.cam_from_world, centre));
    }
    if (!(of_eye > 0) || of_views.empty()) return std::nullopt;
    return median_of(std::move(of_views)) / of_eye;
}

double texels_per_pixel(const Lumigraph& lumigraph, const Eye& eye) {
    const auto samples = samples_per_pixel(lumigraph, eye, [](const LumigraphView& view) {
        return static_cast<double>(view.depth.inverse_depth.width()) / view.camera.width_px;
    });
    if (!samples) return 1.0;
    const double in_steps = std::ceil(kSteps * *samples) / kSteps;
    return in_steps > kNearlyAll ? 1.0 : std::max(in_steps, kLeastTexelsPerPixel);
}

/// How wide a block of the eye's pixels is, in pixels of the photographs; empty as above.
std::optional<double> block_px(const Lumigraph& lumigraph, const Eye& eye) {
    const auto photograph_pixels =
        samples_per_pixel(lumigraph, eye, [](const LumigraphView&) { return 1.0; });
    if (!photograph_pixels) return std::nullopt;
    return kDepthBlockSide_px * *photograph_pixels;
}

/// Whether a Lumigraph's pixels are drawn alone, and may have several texels each.
bool may_be_smooth(const Lumigraph& lumigraph, const RenderOptions& options) {
    return options.smooth_silhouettes && !options.fade_beyond_capture &&
           lumigraph.mesh.shells.empty();
}

double texels_asked_per_pixel(const Lumigraph& lumigraph, const Eye& eye,
                              const RenderOptions& options) {
    if (options.supersample) return 1.0;
    if (is_drawn_in_blocks(lumigraph, eye, options)) return kLeastTexelsPerPixel;
    const double texels = texels_per_pixel(lumigraph, eye);
    return texels == 1.0 && may_be_smooth(lumigraph, options) ? kSmoothTexelsPerPixel : texels;
}

int texels(int pixels, double per_pixel) { return static_cast<int>(std::ceil(pixels * per_pixel)); }

}  // namespace

bool is_drawn_in_blocks(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options) {
    if (options.supersample || options.fade_beyond_capture) return false;
    if (lumigraph.drawing.depth_block_px >= kMaxDepthBlock_px) return true;
    const std::optional<double> width_px = block_px(lumigraph, eye);
    return width_px && *width_px <= lumigraph.drawing.depth_block_px;
}

DepthEye depth_eye(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options) {
    const double scale = texels_asked_per_pixel(lumigraph, eye, options);
    const Eigen::Vector2d focal = scale * focal_length_px(eye.camera);
    const Eigen::Vector2d principal_point = scale * principal_point_px(eye.camera);
    const Camera camera{texels(eye.camera.width_px, scale),
                        texels(eye.camera.height_px, scale),
                        LensModel::kPinhole,
                        {focal.x(), focal.y(), principal_point.x(), principal_point.y()}};
    return {{camera, eye.cam_from_world}, scale};
}

}  // namespace lumi
