#include "render/paths/path_through_views.h"

#include <algorithm>
#include <cmath>

#include "render/paths/pose_between.h"

namespace lumi {
namespace {

Camera fitting_camera(const Camera& camera, int width_px, int height_px) {
    const double scale = std::min(static_cast<double>(width_px) / camera.width_px,
                                  static_cast<double>(height_px) / camera.height_px);
    return pinhole_camera(width_px, height_px, scale * focal_length_px(camera).mean());
}

}  // namespace

std::vector<Eye> path_through_views(const Lumigraph& lumigraph, int count, int width_px,
                                    int height_px) {
    const std::vector<LumigraphView>& views = lumigraph.views;
    const Camera camera = fitting_camera(views.front().camera, width_px, height_px);
    std::vector<Eye> path;
    for (int i = 0; i < count; ++i) {
        const double along = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        const double place = along * static_cast<double>(views.size() - 1);
        const auto from = static_cast<std::size_t>(std::floor(place));
        const std::size_t to = std::min(from + 1, views.size() - 1);
        path.push_back({camera, pose_between(views[from].cam_from_world, views[to].cam_from_world,
                                             place - std::floor(place))});
    }
    return path;
}

}  // namespace lumi
