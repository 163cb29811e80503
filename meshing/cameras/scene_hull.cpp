#include "meshing/cameras/scene_hull.h"

#include <algorithm>
#include <set>

#include "calib/work/median.h"
#include "meshing/cameras/convex_hull.h"

namespace lumi {
namespace {

constexpr double kUsualShare = 0.9;
/// Points so many times farther from the median than the usual share are outliers.
constexpr double kOutlier = 1.3;

Eigen::Vector3d median_of(const std::vector<Eigen::Vector3d>& points) {
    Eigen::Vector3d median;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const Eigen::Vector3d& point : points) values.push_back(point[axis]);
        median[axis] = quantile_of(std::move(values), 0.5);
    }
    return median;
}

}  // namespace

std::vector<Eigen::Vector3d> scene_hull(const std::vector<Eigen::Vector3d>& points,
                                        double kept_share) {
    if (points.empty()) return {};
    const Eigen::Vector3d middle = median_of(points);
    std::vector<double> distances;
    for (const Eigen::Vector3d& point : points) distances.push_back((point - middle).norm());
    const double limit = std::min(quantile_of(distances, kept_share),
                                  kOutlier * quantile_of(distances, kUsualShare));
    std::vector<Eigen::Vector3d> kept;
    std::copy_if(points.begin(), points.end(), std::back_inserter(kept),
                 [&](const Eigen::Vector3d& point) { return (point - middle).norm() <= limit; });

    std::set<int> corners;
    for (const auto& face : convex_hull_faces(kept)) corners.insert(face.begin(), face.end());
    if (corners.empty()) return kept;
    std::vector<Eigen::Vector3d> hull;
    for (const int corner : corners) hull.push_back(kept[static_cast<std::size_t>(corner)]);
    return hull;
}

}  // namespace lumi
