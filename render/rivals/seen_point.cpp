#include "render/rivals/seen_point.h"

#include <algorithm>
#include <cmath>

#include "calib/capture/nearest_byte.h"
#include "render/transfer/sampling.h"

namespace lumi {

Eigen::Vector3d SeenPoint::color() const { return bilinear(view->photograph, pixel); }

double SeenPoint::depth_difference_share() const { return std::abs(depth - map_depth) / depth; }

std::optional<SeenPoint> seen_point(const LumigraphView& view,
                                    const Eigen::Vector3d& point_in_world) {
    const Eigen::Vector3d in_view = view.cam_from_world * point_in_world;
    const auto pixel = project(view.camera, in_view);
    if (!pixel || !is_inside(view.camera, *pixel)) return std::nullopt;
    const FloatImage& map = view.depth.inverse_depth;
    const double inverse_depth = nearest(map, {pixel->x() * map.width() / view.camera.width_px,
                                               pixel->y() * map.height() / view.camera.height_px});
    return SeenPoint{&view, *pixel, in_view.z(), 1 / std::max(inverse_depth, 1e-12)};
}

void set_pixel(Frame& frame, int x, int y, const Eigen::Vector3d& color) {
    frame.color(x, y) = {nearest_byte(color.x()), nearest_byte(color.y()), nearest_byte(color.z())};
    frame.coverage(x, y) = 255;
}

}  // namespace lumi
