#include "render/modes/depth_view_choice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/modes/scene_plane.h"

namespace lumi {
namespace {

constexpr int kGridSteps = 6;
/// Angles much smaller than this count the same.
constexpr double kSameDirection_rad = 0.02;

/// A point of the scene plane as (direction, inverse depth) in the eye's frame: X = direction / q.
struct Sample {
    Eigen::Vector3d direction_in_world;
    double inverse_depth = 0.0;
};

std::vector<Sample> samples_seen_by(const Lumigraph& lumigraph, const Eye& eye) {
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    std::vector<Sample> samples;
    for (int row = 0; row < kGridSteps; ++row) {
        for (int column = 0; column < kGridSteps; ++column) {
            const Eigen::Vector2d pixel((column + 0.5) * eye.camera.width_px / kGridSteps,
                                        (row + 0.5) * eye.camera.height_px / kGridSteps);
            samples.push_back(
                {eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, pixel),
                 std::max(0.0, plane.dot(pixel.homogeneous()))});
        }
    }
    return samples;
}

double score(const LumigraphView& view, const Eigen::Vector3d& eye_in_world,
             const std::vector<Sample>& samples) {
    const Eigen::Vector3d eye_from_view = centre_in_world(view.cam_from_world) - eye_in_world;
    double sum = 0;
    for (const Sample& sample : samples) {
        const Eigen::Vector3d from_view =
            sample.direction_in_world - sample.inverse_depth * eye_from_view;
        const auto pixel = project(view.camera, view.cam_from_world.rotation * from_view);
        if (!pixel || !is_inside(view.camera, *pixel)) continue;
        const double angle = std::atan2(from_view.cross(sample.direction_in_world).norm(),
                                        from_view.dot(sample.direction_in_world));
        sum += 1 / (angle * angle + kSameDirection_rad * kSameDirection_rad);
    }
    return sum;
}

}  // namespace

std::vector<int> choose_depth_views(const Lumigraph& lumigraph, const Eye& eye, int max_views) {
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    const std::vector<Sample> samples = samples_seen_by(lumigraph, eye);
    std::vector<double> scores;
    for (const LumigraphView& view : lumigraph.views)
        scores.push_back(score(view, eye_in_world, samples));
    std::vector<int> order(scores.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return scores[static_cast<std::size_t>(a)] > scores[static_cast<std::size_t>(b)];
    });
    if (scores[static_cast<std::size_t>(order.front())] > 0)
        std::erase_if(order, [&](int view) { return scores[static_cast<std::size_t>(view)] <= 0; });
    order.resize(std::min(order.size(), static_cast<std::size_t>(max_views)));
    return order;
}

}  // namespace lumi
