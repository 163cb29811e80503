#include "render/rivals/view_dependent_texture.h"

#include <algorithm>
#include <cmath>

#include "meshing/rivals/view_dependent_weights.h"
#include "render/reference/eye_depths.h"
#include "render/rivals/seen_point.h"

namespace lumi {
namespace {

struct ChosenView {
    std::size_t index = 0;
    double weight = 0.0;
};

std::vector<ChosenView> choose_views(const Lumigraph& lumigraph,
                                     const Eigen::Vector3d& eye_in_world,
                                     const Eigen::Vector3d& point, double epsilon) {
    std::vector<std::size_t> seeing;
    std::vector<Eigen::Vector3d> centres;
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        const auto seen = seen_point(lumigraph.views[i], point);
        if (!seen || seen->depth_difference_share() > epsilon) continue;
        seeing.push_back(i);
        centres.push_back(centre_in_world(lumigraph.views[i].cam_from_world));
    }
    const std::vector<double> weights = view_dependent_weights(centres, eye_in_world, point);
    std::vector<ChosenView> chosen;
    for (std::size_t k = 0; k < seeing.size(); ++k)
        if (weights[k] > 0) chosen.push_back({seeing[k], weights[k]});
    return chosen;
}

Eigen::Vector3d blended(const Lumigraph& lumigraph, const std::vector<ChosenView>& chosen,
                        const Eigen::Vector3d& point) {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    double sum = 0;
    for (const ChosenView& view : chosen) {
        const auto seen = seen_point(lumigraph.views[view.index], point);
        if (!seen) continue;
        color += view.weight * seen->color();
        sum += view.weight;
    }
    return sum > 0 ? (color / sum).eval() : color;
}

}  // namespace

Frame draw_view_dependent_texture(const Lumigraph& lumigraph, const Eye& eye,
                                  const ViewDependentTextureOptions& options) {
    const EyeDepths known = eye_depths(lumigraph, eye, options.tolerance_px);
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    Frame frame = empty_frame(eye.camera);
    struct Polygon {
        double inverse_depth;
        std::vector<ChosenView> views;
    };
    const int size = options.polygon_px;
    for (int top = 0; top < frame.color.height(); top += size) {
        for (int left = 0; left < frame.color.width(); left += size) {
            std::vector<Polygon> polygons;  // Of this square, one a surface.
            for (int y = top; y < std::min(top + size, frame.color.height()); ++y) {
                for (int x = left; x < std::min(left + size, frame.color.width()); ++x) {
                    const ConsensusDepth& depth = known.depths(x, y);
                    if (depth.support == 0 || !(depth.inverse_depth > 0)) continue;
                    const Eigen::Vector3d point = point_in_world(eye, x, y, depth.inverse_depth);
                    const auto same_surface = [&](const Polygon& polygon) {
                        return std::abs(polygon.inverse_depth - depth.inverse_depth) <
                               4 * options.occlusion_epsilon * depth.inverse_depth;
                    };
                    auto polygon = std::find_if(polygons.begin(), polygons.end(), same_surface);
                    if (polygon == polygons.end())
                        polygon = polygons.insert(
                            polygon,
                            {depth.inverse_depth, choose_views(lumigraph, eye_in_world, point,
                                                               options.occlusion_epsilon)});
                    if (!polygon->views.empty())
                        set_pixel(frame, x, y, blended(lumigraph, polygon->views, point));
                }
            }
        }
    }
    return frame;
}

}  // namespace lumi
