#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "render/faces/face_polygons.h"
#include "render/transfer/polygon_extent.h"

namespace lumi {

/// The triangles that a subdivision begins with: face polygons, triangulated and split in four
/// until some edge is no longer than any edge may be, whatever is seen there. Neighbours mostly
/// follow each other.
struct CoarseTriangles {
    struct Triangle {
        std::array<std::uint32_t, 3> corners{};
        std::uint32_t polygon = 0;
    };
    std::vector<Eigen::Vector2d> pixels;  ///< That corners name; polygons share none.
    std::vector<Triangle> triangles;
};

[[nodiscard]] CoarseTriangles coarse_triangles(const std::vector<FacePolygon>& polygons,
                                               double max_edge_px);

/// An edge's length as a float, in which all lengths of edges are compared.
[[nodiscard]] inline float edge_length_px(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return static_cast<float>((a - b).norm());
}

/// Whether all of a triangle's corners lie nearly on its longest edge: split in four it stays flat.
[[nodiscard]] inline bool is_flat(const Eigen::Vector2d& ab, const Eigen::Vector2d& ac,
                                  float longest_px) {
    constexpr double kFlattest = 0.125;
    const auto longest = static_cast<double>(longest_px);
    return doubled_area_px2(ab, ac) < kFlattest * longest * longest;
}

/// Whether a triangle has an altitude below a quarter of the shortest edge.
[[nodiscard]] inline bool is_thin(const Eigen::Vector2d& ab, const Eigen::Vector2d& ac,
                                  float longest_px, double min_edge_px) {
    constexpr double kThinnest = 0.25;
    return doubled_area_px2(ab, ac) < kThinnest * min_edge_px * static_cast<double>(longest_px);
}

}  // namespace lumi
