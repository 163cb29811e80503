#include "render/rivals/forward_warping.h"

#include <algorithm>
#include <cmath>

#include "calib/capture/inverse_depth_warp.h"
#include "render/rivals/seen_point.h"
#include "render/transfer/sampling.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {
namespace {

constexpr double kMostMagnified = 8.0;

/// What has arrived at a pixel.
struct Arrived {
    double inverse_depth = -1.0;
    Eigen::Vector3d color = Eigen::Vector3d::Zero();  ///< Times weight.
    double weight = 0.0;
};

void arrive(Arrived& pixel, double inverse_depth, const Rgb8& color, double weight,
            double same_share) {
    const double difference = inverse_depth - pixel.inverse_depth;
    if (difference < -same_share * pixel.inverse_depth) return;
    if (difference > same_share * inverse_depth) pixel = {inverse_depth};
    pixel.color += weight * Eigen::Vector3d(color.r, color.g, color.b);
    pixel.weight += weight;
}

void warp(const LumigraphView& view, const Eye& eye, double weight,
          const ForwardWarpingOptions& options, Image<Arrived>& arrived) {
    const InverseDepthWarp eye_from_view = warp_from(view).to(eye);
    const double zoom = focal_length_px(eye.camera).mean() / focal_length_px(view.camera).mean();
    const FloatImage& map = view.depth.inverse_depth;
    for (int y = 0; y < view.camera.height_px; ++y) {
        for (int x = 0; x < view.camera.width_px; ++x) {
            const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
            const double q = nearest(map, {pixel.x() * map.width() / view.camera.width_px,
                                           pixel.y() * map.height() / view.camera.height_px});
            const auto at = eye_from_view.at(pixel, q);
            if (!at || at->pixel.cwiseAbs().maxCoeff() > 1e6) continue;
            const Eigen::Vector2d& there = at->pixel;
            const double splat_px =
                options.splat_px * std::clamp(zoom / at->depth_ratio, 1.0, kMostMagnified);
            const auto first = [&](double place) {
                return static_cast<int>(std::max(0.0, std::ceil(place - splat_px - 0.5)));
            };
            const auto end = [&](double place, int size) {
                return static_cast<int>(
                    std::min<double>(size, std::floor(place + splat_px - 0.5) + 1));
            };
            for (int row = first(there.y()); row < end(there.y(), arrived.height()); ++row)
                for (int column = first(there.x()); column < end(there.x(), arrived.width());
                     ++column)
                    arrive(arrived(column, row), at->inverse_depth, view.photograph(x, y), weight,
                           options.same_share);
        }
    }
}

}  // namespace

Frame draw_forward_warping(const Lumigraph& lumigraph, const Eye& eye,
                           const ForwardWarpingOptions& options) {
    Image<Arrived> arrived(eye.camera.width_px, eye.camera.height_px);
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    for (const int index : choose_depth_views(lumigraph, eye, options.views)) {
        const LumigraphView& view = lumigraph.views[static_cast<std::size_t>(index)];
        const double distance = (centre_in_world(view.cam_from_world) - eye_in_world).norm();
        warp(view, eye, 1 / std::max(distance, 1e-9), options, arrived);
    }
    Frame frame = empty_frame(eye.camera);
    for (int y = 0; y < arrived.height(); ++y)
        for (int x = 0; x < arrived.width(); ++x)
            if (arrived(x, y).weight > 0)
                set_pixel(frame, x, y, arrived(x, y).color / arrived(x, y).weight);
    return frame;
}

}  // namespace lumi
