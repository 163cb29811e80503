#include "meshing/depth_scene/point_triangulation.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace lumi {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, Structure>;

}  // namespace

PointTriangulation triangulate(const std::vector<SparsePoint>& points) {
    Delaunay delaunay;
    Delaunay::Face_handle near_last;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t before = delaunay.number_of_vertices();
        const auto vertex =
            delaunay.insert(Delaunay::Point(points[i].pixel.x(), points[i].pixel.y()), near_last);
        if (delaunay.number_of_vertices() > before) vertex->info() = static_cast<int>(i);
        near_last = vertex->face();
    }
    PointTriangulation result;
    result.rings.resize(points.size());
    for (const auto& face : delaunay.finite_face_handles()) {
        result.triangles.push_back(
            {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
    for (const auto& edge : delaunay.finite_edges()) {
        const int a = edge.first->vertex(Delaunay::cw(edge.second))->info();
        const int b = edge.first->vertex(Delaunay::ccw(edge.second))->info();
        result.rings[static_cast<std::size_t>(a)].push_back(b);
        result.rings[static_cast<std::size_t>(b)].push_back(a);
    }
    return result;
}

}  // namespace lumi
