#include "meshing/cameras/own_rays.h"

#include <algorithm>
#include <set>

namespace lumi {
namespace {

/// Of the pairs of a camera and a point as many are looked at, and of the rays as many weighed.
constexpr std::size_t kPairsAsked = 50'000;
constexpr std::size_t kMostRays = 1000;

struct OwnRay {
    int view_index = 0;
    Eigen::Vector3d point_in_world;
};

bool is_in_picture(const Capture& capture, const OwnRay& ray) {
    const View& view = capture.views[static_cast<std::size_t>(ray.view_index)];
    const Camera& camera = camera_of(capture, view);
    const auto pixel = project(camera, view.cam_from_world * ray.point_in_world);
    return pixel && is_inside(camera, *pixel);
}

std::vector<OwnRay> rays_of_cameras(const Capture& capture, const CameraMesh& mesh,
                                    const std::vector<Eigen::Vector3d>& scene_in_world) {
    std::set<int> views;
    for (const CameraMesh::Vertex& vertex : mesh.vertices) views.insert(vertex.view_index);
    // Odd: other points of every view.
    const std::size_t step = (views.size() * scene_in_world.size() / kPairsAsked) | 1;
    std::vector<OwnRay> rays;
    std::size_t pair = 0;
    for (const int view : views) {
        for (const Eigen::Vector3d& point : scene_in_world) {
            if (pair++ % step == 0 && is_in_picture(capture, {view, point}))
                rays.push_back({view, point});
        }
    }
    return rays;
}

double own_weight(const Capture& capture, const CameraMesh& mesh, const OwnRay& ray) {
    const View& view = capture.views[static_cast<std::size_t>(ray.view_index)];
    const Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
    const auto weights = weights_of_ray(mesh, centre, ray.point_in_world - centre);
    double own = 0;
    for (std::size_t i = 0; weights && i < 3; ++i) {
        if (weights->view_indices[i] == ray.view_index) own += weights->weights[i];
    }
    return own;
}

}  // namespace

double own_ray_share(const Capture& capture, const CameraMesh& mesh,
                     const std::vector<Eigen::Vector3d>& scene_in_world) {
    const std::vector<OwnRay> rays = rays_of_cameras(capture, mesh, scene_in_world);
    const std::size_t count = std::min(rays.size(), kMostRays);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += own_weight(capture, mesh, rays[i * rays.size() / count]);
    return count > 0 ? sum / static_cast<double>(count) : 1.0;
}

}  // namespace lumi
