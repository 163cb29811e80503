#include "pipeline/protocol/view_subset.h"

#include <algorithm>
#include <numeric>

#include "meshing/cameras/camera_mesh_builder.h"

namespace lumi {
namespace {

constexpr int kPointsAcross = 12;

/// What a view is sure to see, on a coarse grid: stands in for the scene points, which a package
/// holds for looking at alone.
void append_scene_points(const LumigraphView& view, std::vector<ScenePoint>& points) {
    const FloatImage& inverse_depth = view.depth.inverse_depth;
    if (inverse_depth.empty()) return;
    const Rigid3 world_from_cam = inverse(view.cam_from_world);
    const Camera camera = resized(view.camera, inverse_depth.width(), inverse_depth.height());
    const int step = std::max(1, inverse_depth.width() / kPointsAcross);
    for (int y = step / 2; y < inverse_depth.height(); y += step) {
        for (int x = step / 2; x < inverse_depth.width(); x += step) {
            const auto value = static_cast<double>(inverse_depth(x, y));
            if (value <= 0.0 || !was_seen(view.depth.confidence(x, y))) continue;
            ScenePoint point;
            point.position_in_world =
                world_from_cam * (unproject(camera, {x + 0.5, y + 0.5}) / value);
            points.push_back(std::move(point));
        }
    }
}

Capture capture_of(const Lumigraph& lumigraph) {
    Capture capture;
    for (const LumigraphView& view : lumigraph.views) {
        capture.views.push_back(
            {view.name, static_cast<int>(capture.cameras.size()), view.cam_from_world});
        capture.cameras.push_back(view.camera);
        append_scene_points(view, capture.points);
    }
    return capture;
}

}  // namespace

Lumigraph only_these_views(const Lumigraph& lumigraph, const std::vector<int>& kept,
                           const CameraMeshOptions& mesh_options) {
    Lumigraph result = without_its_views(lumigraph);
    for (const int index : kept) {
        result.views.push_back(lumigraph.views[static_cast<std::size_t>(index)]);
    }
    std::vector<int> all(kept.size());
    std::iota(all.begin(), all.end(), 0);
    result.mesh = build_camera_mesh(capture_of(result), all, mesh_options).mesh;
    return result;
}

}  // namespace lumi
