#include "pipeline/synth/exact_points.h"

#include "pipeline/synth/hashed_random.h"
#include "pipeline/synth/photographer.h"

namespace lumi {
namespace {

std::vector<Observation> true_track(const Scene& scene, const Capture& capture,
                                    const Eigen::Vector3d& point_in_world) {
    std::vector<Observation> track;
    for (std::size_t i = 0; i < capture.views.size(); ++i) {
        const View& view = capture.views[i];
        const Camera& camera = camera_of(capture, view);
        const auto pixel = project(camera, view.cam_from_world * point_in_world);
        if (!pixel || !is_inside(camera, *pixel)) continue;
        if (!is_visible_from(scene, centre_in_world(view.cam_from_world), point_in_world)) continue;
        track.push_back({static_cast<int>(i), *pixel});
    }
    return track;
}

}  // namespace

std::vector<ScenePoint> exact_scene_points(const Scene& scene, const Capture& capture, int count,
                                           std::uint64_t seed) {
    std::vector<ScenePoint> points;
    HashedRandom random(seed);
    for (int draw = 0; draw < count && !capture.views.empty(); ++draw) {
        const View& view = capture.views[random.below(capture.views.size())];
        const Camera& camera = camera_of(capture, view);
        const Eigen::Vector2d pixel(camera.width_px * random.uniform(),
                                    camera.height_px * random.uniform());
        const Ray ray = ray_through(camera, inverse(view.cam_from_world), pixel).ray;
        const auto hit = first_hit(scene, ray);
        if (!hit) continue;
        ScenePoint point;
        point.position_in_world = ray.at(hit->distance);
        point.track = true_track(scene, capture, point.position_in_world);
        if (point.track.size() >= 2) points.push_back(std::move(point));
    }
    return points;
}

}  // namespace lumi
