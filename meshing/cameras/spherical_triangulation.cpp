#include "meshing/cameras/spherical_triangulation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <map>

namespace lumi {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

/// Whether some four of the points span a volume.
bool span_a_volume(const std::vector<Point>& points) {
    if (points.size() < 4) return false;
    const auto third = std::find_if(points.begin() + 2, points.end(), [&](const Point& point) {
        return !CGAL::collinear(points[0], points[1], point);
    });
    if (third == points.end()) return false;
    return std::any_of(points.begin() + 2, points.end(), [&](const Point& point) {
        return !CGAL::coplanar(points[0], points[1], *third, point);
    });
}

}  // namespace

std::vector<std::array<int, 3>> spherical_triangulation(
    const std::vector<Eigen::Vector3d>& directions) {
    std::vector<Point> points;
    std::map<Point, int> index_of;
    for (const Eigen::Vector3d& direction : directions) {
        points.emplace_back(direction.x(), direction.y(), direction.z());
        index_of.emplace(points.back(), static_cast<int>(index_of.size()));
    }
    if (!span_a_volume(points)) return {};

    CGAL::Surface_mesh<Point> hull;
    CGAL::convex_hull_3(points.begin(), points.end(), hull);
    std::vector<std::array<int, 3>> faces;
    for (const auto face : hull.faces()) {
        std::array<int, 3> corners{};
        std::size_t corner = 0;
        for (const auto vertex : hull.vertices_around_face(hull.halfedge(face))) {
            corners[corner++] = index_of.at(hull.point(vertex));
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                    corners.end());
        faces.push_back(corners);
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

}  // namespace lumi
