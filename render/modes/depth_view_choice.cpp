#include "render/modes/depth_view_choice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/modes/scene_plane.h"
#include "render/modes/view_geometry.h"

namespace lumi {
namespace {

constexpr int kGridSteps = 9;
/// At this angle between view and eye a view is worth half.
constexpr double kHalfWorth_rad = 0.1;
/// What one more view is worth where others see the same: two must agree, more are spare. No more
/// than that is a view worth for what may stand before the scene plane.
constexpr double kWorthOfNext = 0.1;

/// A point that the eye may see, as (direction, inverse depth) in its frame: X = direction / q.
struct Sample {
    Eigen::Vector3d direction_in_world;
    double inverse_depth = 0.0;
    double worth = 1.0;  ///< To a view that sees it from the eye's direction, the first to do so.
};

std::vector<Sample> samples_seen_by(const Lumigraph& lumigraph, const Eye& eye) {
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    const double near_end = inverse_depth_range(lumigraph).y();
    std::vector<Sample> samples;
    for (int row = 0; row < kGridSteps; ++row) {
        for (int column = 0; column < kGridSteps; ++column) {
            const Eigen::Vector2d pixel(column * eye.camera.width_px / (kGridSteps - 1.0),
                                        row * eye.camera.height_px / (kGridSteps - 1.0));
            const Eigen::Vector3d direction_in_world =
                eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, pixel);
            const double on_plane = std::max(0.0, plane.dot(pixel.homogeneous()));
            samples.push_back({direction_in_world, on_plane});
            samples.push_back({direction_in_world, std::max(on_plane, near_end), kWorthOfNext});
        }
    }
    return samples;
}

/// For each sample how well the view sees it: 1 from the eye's direction, 0 not at all.
std::vector<double> closeness_of(const LumigraphView& view, const Eigen::Vector3d& eye_in_world,
                                 const std::vector<Sample>& samples) {
    const Eigen::Vector3d eye_from_view = centre_in_world(view.cam_from_world) - eye_in_world;
    std::vector<double> closeness;
    for (const Sample& sample : samples) {
        const Eigen::Vector3d from_view =
            sample.direction_in_world - sample.inverse_depth * eye_from_view;
        const auto pixel = project(view.camera, view.cam_from_world.rotation * from_view);
        if (!pixel || !is_inside(view.camera, *pixel)) {
            closeness.push_back(0.0);
            continue;
        }
        const double angle = std::atan2(from_view.cross(sample.direction_in_world).norm(),
                                        from_view.dot(sample.direction_in_world));
        closeness.push_back(kHalfWorth_rad / (kHalfWorth_rad + angle));
    }
    return closeness;
}

double gain_of(const std::vector<double>& closeness, const std::vector<double>& worth) {
    return std::inner_product(closeness.begin(), closeness.end(), worth.begin(), 0.0);
}

}  // namespace

std::vector<int> choose_depth_views(const Lumigraph& lumigraph, const Eye& eye, int max_views) {
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    const std::vector<Sample> samples = samples_seen_by(lumigraph, eye);
    std::vector<std::vector<double>> closeness;
    for (const LumigraphView& view : lumigraph.views)
        closeness.push_back(closeness_of(view, eye_in_world, samples));
    std::vector<double> worth;
    for (const Sample& sample : samples) worth.push_back(sample.worth);
    std::vector<int> chosen;
    while (static_cast<int>(chosen.size()) < max_views) {
        int best = -1;
        double best_gain = chosen.empty() ? -1.0 : 0.0;
        for (int i = 0; i < static_cast<int>(closeness.size()); ++i) {
            if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) continue;
            const double gain = gain_of(closeness[static_cast<std::size_t>(i)], worth);
            if (gain <= best_gain) continue;
            best = i;
            best_gain = gain;
        }
        if (best < 0) break;
        chosen.push_back(best);
        for (std::size_t s = 0; s < worth.size(); ++s)
            if (closeness[static_cast<std::size_t>(best)][s] > 0) worth[s] *= kWorthOfNext;
    }
    return chosen;
}

}  // namespace lumi
