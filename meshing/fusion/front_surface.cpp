#include "meshing/fusion/front_surface.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <iterator>

namespace lumi {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Small triangles first, and none whose edges are too long for the spacing of their points.
class SmallEnough {
 public:
    SmallEnough(const std::vector<SurfacePoint>& points, const std::vector<Kernel::Point_3>& places)
        : points_(&points), places_(&places) {}

    template <class Front, class Cell>
    double operator()(const Front& front, Cell& cell, const int& index) const {
        for (int a = 1; a <= 3; ++a) {
            const auto& from = cell->vertex((index + a) % 4);
            const auto& to = cell->vertex((index + a % 3 + 1) % 4);
            if (!is_of_points(*from) || !is_of_points(*to)) return front.infinity();
            const double longest =
                kLongestEdge * std::max(spacing(from->info()), spacing(to->info()));
            if (CGAL::squared_distance(from->point(), to->point()) > longest * longest) {
                return front.infinity();
            }
        }
        return front.smallest_radius_delaunay_sphere(cell, index);
    }

 private:
    /// Neighbouring cells' points are up to 2 sqrt(3) cells apart.
    static constexpr double kLongestEdge = 3.5;
    /// Where all points lie in one plane, CGAL adds one beside it, whose number is anything.
    template <class Vertex>
    [[nodiscard]] bool is_of_points(const Vertex& vertex) const {
        return vertex.info() < places_->size() && (*places_)[vertex.info()] == vertex.point();
    }
    [[nodiscard]] double spacing(std::size_t point) const {
        return static_cast<double>((*points_)[point].spacing);
    }

    const std::vector<SurfacePoint>* points_;
    const std::vector<Kernel::Point_3>* places_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> front_surface(const std::vector<SurfacePoint>& points) {
    std::vector<Kernel::Point_3> places;
    places.reserve(points.size());
    for (const SurfacePoint& point : points) {
        places.emplace_back(point.position.x(), point.position.y(), point.position.z());
    }
    std::vector<std::array<std::size_t, 3>> found;
    CGAL::advancing_front_surface_reconstruction(
        places.begin(), places.end(), std::back_inserter(found), SmallEnough(points, places));
    std::vector<std::array<std::uint32_t, 3>> faces;
    faces.reserve(found.size());
    for (const auto& corners : found) {
        std::array<std::uint32_t, 3> face{};
        std::transform(corners.begin(), corners.end(), face.begin(),
                       [](std::size_t corner) { return static_cast<std::uint32_t>(corner); });
        const auto& [a, b, c] = face;
        const Eigen::Vector3d outwards = (points[b].position - points[a].position)
                                             .cross(points[c].position - points[a].position);
        const Eigen::Vector3f normal = points[a].normal + points[b].normal + points[c].normal;
        if (outwards.dot(normal.cast<double>()) < 0) std::swap(face[1], face[2]);
        faces.push_back(face);
    }
    return faces;
}

}  // namespace lumi
