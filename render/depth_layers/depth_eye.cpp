#include "render/depth_layers/depth_eye.h"

#include <algorithm>
#include <cmath>
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

double texels_per_pixel(const Lumigraph& lumigraph, const Eye& eye) {
    const Eigen::Vector3d& centre = lumigraph.mesh.scene_centre_in_world;
    const double of_eye = pixels_per_unit(eye.camera, eye.cam_from_world, centre);
    std::vector<double> of_depth_maps;
    for (const LumigraphView& view : lumigraph.views) {
        if (view.depth.inverse_depth.empty()) continue;
        const double samples_per_view_pixel =
            static_cast<double>(view.depth.inverse_depth.width()) / view.camera.width_px;
        of_depth_maps.push_back(samples_per_view_pixel *
                                pixels_per_unit(view.camera, view.cam_from_world, centre));
    }
    if (!(of_eye > 0) || of_depth_maps.empty()) return 1.0;
    const double samples_per_pixel = median_of(std::move(of_depth_maps)) / of_eye;
    const double in_steps = std::ceil(kSteps * samples_per_pixel) / kSteps;
    return in_steps > kNearlyAll ? 1.0 : std::max(in_steps, kLeastTexelsPerPixel);
}

/// Whether a Lumigraph's pixels are drawn alone, and may have several texels each.
bool may_be_smooth(const Lumigraph& lumigraph, const RenderOptions& options) {
    return options.smooth_silhouettes && !options.fade_beyond_capture &&
           lumigraph.mesh.shells.empty();
}

double texels_asked_per_pixel(const Lumigraph& lumigraph, const Eye& eye,
                              const RenderOptions& options) {
    if (options.supersample) return 1.0;
    if (is_drawn_in_blocks(lumigraph, options)) return kLeastTexelsPerPixel;
    const double texels = texels_per_pixel(lumigraph, eye);
    return texels == 1.0 && may_be_smooth(lumigraph, options) ? kSmoothTexelsPerPixel : texels;
}

int texels(int pixels, double per_pixel) { return static_cast<int>(std::ceil(pixels * per_pixel)); }

}  // namespace

bool is_drawn_in_blocks(const Lumigraph& lumigraph, const RenderOptions& options) {
    return lumigraph.depth_block_px > 1 && !options.supersample && !options.fade_beyond_capture;
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
