#include "meshing/cameras/spherical_triangulation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace lumi {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Hull = CGAL::Surface_mesh<Point>;

double cap_angle_rad(const std::array<int, 3>& corners,
                     const std::vector<Eigen::Vector3d>& directions) {
    const auto at = [&](std::size_t i) { return directions[static_cast<std::size_t>(corners[i])]; };
    const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    return std::acos(std::clamp(normal.dot(at(0)), -1.0, 1.0));
}

/// The same three corners, beginning with the smallest, so that the order does not depend on CGAL.
std::array<int, 3> rotated_to_smallest(std::array<int, 3> corners) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
}

}  // namespace

std::vector<SphericalFace> triangulate_sphere(const std::vector<Eigen::Vector3d>& directions) {
    std::vector<Point> points;
    std::map<Point, int> index_of;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        points.emplace_back(directions[i].x(), directions[i].y(), directions[i].z());
        index_of.emplace(points.back(), static_cast<int>(i));
    }
    Hull hull;
    if (points.size() >= 4) CGAL::convex_hull_3(points.begin(), points.end(), hull);

    std::vector<SphericalFace> faces;
    if (hull.number_of_vertices() < 4) return faces;
    for (const auto face : hull.faces()) {
        SphericalFace result;
        std::size_t corner = 0;
        for (const auto vertex : hull.vertices_around_face(hull.halfedge(face))) {
            if (corner < 3) result.corners[corner] = index_of.at(hull.point(vertex));
            ++corner;
        }
        if (corner != 3) continue;  // convex_hull_3 triangulates; a flat hull is the exception.
        result.corners = rotated_to_smallest(result.corners);
        result.cap_angle_rad = cap_angle_rad(result.corners, directions);
        faces.push_back(result);
    }
    std::sort(faces.begin(), faces.end(),
              [](const auto& a, const auto& b) { return a.corners < b.corners; });
    return faces;
}

}  // namespace lumi
