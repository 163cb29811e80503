#include "meshing/surface/points_ply.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "calib/work/median.h"
#include "meshing/surface/ply_places.h"

namespace lumi {
namespace {

double median_distance(const std::vector<ScenePoint>& points, const Eigen::Vector3d& from) {
    std::vector<double> distances;
    for (const ScenePoint& point : points) {
        distances.push_back((point.position_in_world - from).norm());
    }
    return median_of(std::move(distances));
}

Eigen::Vector3d median_place(const std::vector<ScenePoint>& points) {
    Eigen::Vector3d median;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const ScenePoint& point : points) values.push_back(point.position_in_world[axis]);
        median[axis] = median_of(std::move(values));
    }
    return median;
}

/// What lies between two of them on a surface that half of them are spread over evenly: points
/// astray and points found twice tell nothing.
double usual_spacing(const std::vector<ScenePoint>& points) {
    return 2 * median_distance(points, median_place(points)) /
           std::sqrt(static_cast<double>(std::max<std::size_t>(1, points.size())));
}

std::string points_header(std::size_t points, const PlyPlaces& places) {
    return "ply\nformat binary_little_endian 1.0\ncomment lumi scene points\nelement vertex " +
           std::to_string(points) + "\n" + places.properties() +
           "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
}

}  // namespace

Bytes points_ply(const std::vector<ScenePoint>& points) {
    const PlyPlaces places(median_distance(points, Eigen::Vector3d::Zero()), usual_spacing(points));
    const std::string header = points_header(points.size(), places);
    Bytes bytes(header.begin(), header.end());
    for (const ScenePoint& point : points) {
        places.append(point.position_in_world, bytes);
        append_to_ply(point.color, bytes);
    }
    return bytes;
}

}  // namespace lumi
