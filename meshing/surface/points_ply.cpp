#include "meshing/surface/points_ply.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

#include "calib/work/median.h"
#include "meshing/surface/places_in_floats.h"

namespace lumi {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY is written little-endian");

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

void append(const void* data, std::size_t size, Bytes& bytes) {
    const auto* begin = static_cast<const std::uint8_t*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
}

std::string points_header(std::size_t points, const std::string& type) {
    std::string header =
        "ply\nformat binary_little_endian 1.0\ncomment lumi scene points\nelement vertex " +
        std::to_string(points) + "\n";
    for (const char* axis : {"x", "y", "z"}) header += "property " + type + " " + axis + "\n";
    for (const char* channel : {"red", "green", "blue"}) {
        header += std::string("property uchar ") + channel + "\n";
    }
    return header + "end_header\n";
}

}  // namespace

Bytes points_ply(const std::vector<ScenePoint>& points) {
    const bool are_floats =
        floats_hold_places(median_distance(points, Eigen::Vector3d::Zero()), usual_spacing(points));
    const std::string header = points_header(points.size(), are_floats ? "float" : "double");
    Bytes bytes(header.begin(), header.end());
    for (const ScenePoint& point : points) {
        const Eigen::Vector3f rounded = point.position_in_world.cast<float>();
        if (are_floats) {
            append(rounded.data(), 3 * sizeof(float), bytes);
        } else {
            append(point.position_in_world.data(), 3 * sizeof(double), bytes);
        }
        append(&point.color, sizeof(Rgb8), bytes);
    }
    return bytes;
}

}  // namespace lumi
