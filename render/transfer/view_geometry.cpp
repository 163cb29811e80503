#include "render/transfer/view_geometry.h"

#include <algorithm>

#include "calib/work/median.h"

namespace lumi {
namespace {

/// Of the scene's depth: cameras so close together, as on one tripod, tell each other nothing of
/// depth.
constexpr double kSamePlace = 1e-3;

/// The depth at which disparities are halfway between those of the near and the far end.
double middle_depth(const Lumigraph& lumigraph) {
    const InverseDepthRange scene = scene_inverse_depths(lumigraph);
    return 2 / (scene.far + scene.near);
}

}  // namespace

InverseDepthRange scene_inverse_depths(const Lumigraph& lumigraph) {
    if (lumigraph.near_depth > 0 && lumigraph.far_depth > lumigraph.near_depth)
        return {1 / lumigraph.far_depth, 1 / lumigraph.near_depth};
    const Eigen::Vector3d centre = centre_in_world(lumigraph.views.front().cam_from_world);
    const double distance = (lumigraph.mesh.scene_centre_in_world - centre).norm();
    return {0, 2 / (distance > 0 ? distance : 1.0)};
}

double nearest_inverse_depth(const Lumigraph& lumigraph) {
    constexpr double kTimesNearer = 100.0;
    return kTimesNearer * scene_inverse_depths(lumigraph).near;
}

std::vector<ViewGeometry> view_geometries(const Lumigraph& lumigraph) {
    std::vector<ViewGeometry> geometries;
    for (const LumigraphView& view : lumigraph.views) {
        geometries.push_back(
            {centre_in_world(view.cam_from_world), focal_length_px(view.camera).mean()});
    }
    const auto neighbours = neighbouring_views(lumigraph.mesh, geometries.size());
    for (std::size_t i = 0; i < geometries.size(); ++i) {
        std::vector<double> distances;
        for (const int neighbour : neighbours[i]) {
            const double distance =
                (geometries[static_cast<std::size_t>(neighbour)].centre_in_world -
                 geometries[i].centre_in_world)
                    .norm();
            if (distance > kSamePlace * middle_depth(lumigraph)) distances.push_back(distance);
        }
        geometries[i].baseline =
            distances.empty() ? 0.1 * middle_depth(lumigraph) : median_of(std::move(distances));
    }
    return geometries;
}

double disparity_px_per_inverse_depth(const ViewGeometry& view,
                                      const Eigen::Vector3d& eye_in_world) {
    const double distance = (view.centre_in_world - eye_in_world).norm();
    return view.focal_px * std::min(distance, view.baseline);
}

double max_disparity_px(const ViewGeometry& view) { return view.focal_px * view.baseline; }

double inverse_depth_in_eye(const std::vector<ViewGeometry>& views,
                            const Eigen::Vector3d& scene_centre_in_world,
                            const Eigen::Vector3d& eye_in_world) {
    constexpr double kMostTimesNearer = 4.0;
    std::vector<double> distances;
    for (const ViewGeometry& view : views)
        distances.push_back((view.centre_in_world - scene_centre_in_world).norm());
    const double of_views = median_of(std::move(distances));
    const double of_eye = (eye_in_world - scene_centre_in_world).norm();
    const double times_nearer =
        of_eye * kMostTimesNearer > of_views ? of_views / of_eye : kMostTimesNearer;
    return times_nearer * times_nearer;
}

double agreeing_inverse_depth(const Lumigraph& lumigraph, const std::vector<ViewGeometry>& views,
                              const std::vector<int>& view_indices,
                              const Eigen::Vector3d& eye_in_world, double tolerance_px) {
    std::vector<double> disparities;
    for (const int index : view_indices)
        disparities.push_back(max_disparity_px(views[static_cast<std::size_t>(index)]));
    return 2 * tolerance_px / median_of(std::move(disparities)) *
           inverse_depth_in_eye(views, lumigraph.mesh.scene_centre_in_world, eye_in_world);
}

}  // namespace lumi
