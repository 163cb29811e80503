#include "render/viewer/scene_bounds.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "calib/work/median.h"

namespace lumi {
namespace {

Eigen::Vector3d point_at(const LumigraphView& view, int x, int y) {
    const FloatImage& inverse_depth = view.depth.inverse_depth;
    const Camera camera = resized(view.camera, inverse_depth.width(), inverse_depth.height());
    const Eigen::Vector3d at_depth_one = unproject(camera, {x + 0.5, y + 0.5});
    return inverse(view.cam_from_world) *
           Eigen::Vector3d(at_depth_one / static_cast<double>(inverse_depth(x, y)));
}

/// Points on a coarse grid of each view, where depth is known and finite.
std::vector<Eigen::Vector3d> confident_points(const Lumigraph& lumigraph) {
    constexpr int kGrid = 24;
    std::vector<Eigen::Vector3d> points;
    for (const LumigraphView& view : lumigraph.views) {
        const FloatImage& inverse_depth = view.depth.inverse_depth;
        const int step =
            std::max(1, std::max(inverse_depth.width(), inverse_depth.height()) / kGrid);
        for (int y = step / 2; y < inverse_depth.height(); y += step) {
            for (int x = step / 2; x < inverse_depth.width(); x += step) {
                if (inverse_depth(x, y) > 0.0F && was_seen(view.depth.confidence(x, y))) {
                    points.push_back(point_at(view, x, y));
                }
            }
        }
    }
    return points;
}

SceneBounds bounds_without_depth(const Lumigraph& lumigraph) {
    std::vector<double> distances;
    const Eigen::Vector3d& centre = lumigraph.mesh.scene_centre_in_world;
    for (const LumigraphView& view : lumigraph.views) {
        distances.push_back((centre_in_world(view.cam_from_world) - centre).norm());
    }
    const double distance = quantile_of(std::move(distances), 0.5);
    return {centre, distance > 0 ? 0.5 * distance : 1.0};
}

}  // namespace

SceneBounds bounds_of(const Lumigraph& lumigraph) {
    const std::vector<Eigen::Vector3d> points = confident_points(lumigraph);
    if (points.empty()) return bounds_without_depth(lumigraph);
    SceneBounds bounds;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> coordinates;
        for (const Eigen::Vector3d& point : points) coordinates.push_back(point[axis]);
        bounds.centre_in_world[axis] = quantile_of(std::move(coordinates), 0.5);
    }
    std::vector<double> distances;
    for (const Eigen::Vector3d& point : points) {
        distances.push_back((point - bounds.centre_in_world).norm());
    }
    bounds.radius = quantile_of(std::move(distances), 0.9);
    return bounds.radius > 0 ? bounds : bounds_without_depth(lumigraph);
}

Eigen::Vector3d point_in_the_middle(const Lumigraph& lumigraph, const LumigraphView& view) {
    const FloatImage& inverse_depth = view.depth.inverse_depth;
    const int x = inverse_depth.width() / 2;
    const int y = inverse_depth.height() / 2;
    if (!inverse_depth.empty() && inverse_depth(x, y) > 0.0F) return point_at(view, x, y);

    const Eigen::Vector3d centre_in_cam =
        view.cam_from_world * lumigraph.mesh.scene_centre_in_world;
    const double depth = centre_in_cam.z() > 0 ? centre_in_cam.z() : centre_in_cam.norm();
    const Eigen::Vector2d middle(0.5 * view.camera.width_px, 0.5 * view.camera.height_px);
    return inverse(view.cam_from_world) * Eigen::Vector3d(depth * unproject(view.camera, middle));
}

}  // namespace lumi
