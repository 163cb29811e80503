#include "meshing/cameras/convex_hull.h"

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
    const auto second = std::find_if(points.begin() + 1, points.end(),
                                     [&](const Point& point) { return point != points[0]; });
    if (second == points.end()) return false;
    const auto third = std::find_if(points.begin() + 1, points.end(), [&](const Point& point) {
        return !CGAL::collinear(points[0], *second, point);
    });
    if (third == points.end()) return false;
    return std::any_of(points.begin() + 1, points.end(), [&](const Point& point) {
        return !CGAL::coplanar(points[0], *second, *third, point);
    });
}

}  // namespace

std::vector<std::array<int, 3>> convex_hull_faces(const std::vector<Eigen::Vector3d>& points) {
    std::vector<Point> places;
    std::map<Point, int> index_of;
    for (const Eigen::Vector3d& point : points) {
        places.emplace_back(point.x(), point.y(), point.z());
        index_of.emplace(places.back(), static_cast<int>(places.size()) - 1);
    }
    if (!span_a_volume(places)) return {};

    CGAL::Surface_mesh<Point> hull;
    CGAL::convex_hull_3(places.begin(), places.end(), hull);
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
