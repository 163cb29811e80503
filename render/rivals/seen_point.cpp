#include "render/rivals/seen_point.h"

#include <algorithm>
#include <cmath>

#include "calib/capture/nearest_byte.h"
#include "render/depth_search/occlusion.h"
#include "render/transfer/sampling.h"
#include "render/transfer/view_geometry.h"

namespace lumi {
namespace {

constexpr double kTimesAsFar = 100.0;
/// Of the scene's greatest inverse depth.
constexpr double kLeastCompared = 0.1;

}  // namespace

SameSurface::SameSurface(const Lumigraph& lumigraph, double share)
    : share_(share), least_compared_(kLeastCompared * scene_inverse_depths(lumigraph).near) {}

bool SameSurface::operator()(double inverse_depth, double other) const {
    return std::abs(inverse_depth - other) <=
           share_ * std::max({inverse_depth, other, least_compared_});
}

Eigen::Vector4d scene_point(const Eye& eye, int x, int y, double inverse_depth) {
    const Eigen::Vector3d ray =
        eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, {x + 0.5, y + 0.5});
    Eigen::Vector4d point;
    point << ray + inverse_depth * centre_in_world(eye.cam_from_world), inverse_depth;
    return point;
}

Eigen::Vector3d PhotographedPoint::color() const { return bilinear(view->photograph, pixel); }

double PhotographedPoint::share_in_view() const {
    const Eigen::Vector2d beyond =
        Eigen::Vector2d(view->camera.width_px, view->camera.height_px) - pixel;
    return border_fade(std::min(pixel.minCoeff(), beyond.minCoeff()));
}

std::optional<PhotographedPoint> photographed_point(const LumigraphView& view,
                                                    const Eigen::Vector4d& point_in_world) {
    const Eigen::Vector3d in_view = view.cam_from_world.rotation * point_in_world.head<3>() +
                                    point_in_world.w() * view.cam_from_world.translation;
    const auto pixel = project(view.camera, in_view);
    if (!pixel || !is_inside(view.camera, *pixel)) return std::nullopt;
    return PhotographedPoint{&view, *pixel, point_in_world.w() / in_view.z()};
}

bool SeenPoint::is_of(const SameSurface& same_surface) const {
    return same_surface(inverse_depth, map_inverse_depth);
}

std::optional<SeenPoint> seen_point(const LumigraphView& view,
                                    const Eigen::Vector4d& point_in_world) {
    const auto point = photographed_point(view, point_in_world);
    if (!point) return std::nullopt;
    const FloatImage& map = view.depth.inverse_depth;
    return SeenPoint{*point,
                     nearest(map, {point->pixel.x() * map.width() / view.camera.width_px,
                                   point->pixel.y() * map.height() / view.camera.height_px})};
}

double least_weighed_inverse_depth(const Lumigraph& lumigraph, const Eye& eye) {
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    double farthest = 1e-12;
    for (const LumigraphView& view : lumigraph.views)
        farthest = std::max(farthest, (centre_in_world(view.cam_from_world) - eye_in_world).norm());
    return 1 / (kTimesAsFar * farthest);
}

void set_pixel(Frame& frame, int x, int y, const Eigen::Vector3d& color) {
    frame.color(x, y) = {nearest_byte(color.x()), nearest_byte(color.y()), nearest_byte(color.z())};
    frame.coverage(x, y) = 255;
}

}  // namespace lumi
