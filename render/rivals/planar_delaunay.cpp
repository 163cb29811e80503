#include "render/rivals/planar_delaunay.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lumi {
namespace {

using Triangle = std::array<int, 3>;
using Edge = std::pair<int, int>;

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Of the terms of a determinant: less than this is rounding. Points may be close together beside
/// others, as a camera's neighbours are where another is in the eye's plane.
constexpr double kRoundingShare = 1e-12;

bool is_within_circle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                      const Eigen::Vector2d& point) {
    const std::array<Eigen::Vector2d, 3> corners{a - point, b - point, c - point};
    double determinant = 0;
    double terms = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d& next = corners[(i + 1) % 3];
        const Eigen::Vector2d& last = corners[(i + 2) % 3];
        const double lift = corners[i].squaredNorm();
        determinant += lift * (next.x() * last.y() - last.x() * next.y());
        terms += lift * (std::abs(next.x() * last.y()) + std::abs(last.x() * next.y()));
    }
    return determinant > kRoundingShare * terms;
}

/// Into the unit square, with the corners of a triangle far around it at the end.
std::vector<Eigen::Vector2d> framed(const std::vector<Eigen::Vector2d>& points) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& point : points) box.extend(point);
    const double size = std::max(box.sizes().maxCoeff(), 1e-300);
    std::vector<Eigen::Vector2d> scaled;
    for (const Eigen::Vector2d& point : points) scaled.push_back((point - box.center()) / size);
    constexpr double kFar = 1e3;
    scaled.insert(scaled.end(), {{-kFar, -kFar}, {kFar, -kFar}, {0, kFar}});
    return scaled;
}

/// The edges of a hole: those that belong to one of its triangles only.
std::vector<Edge> rim_of(const std::vector<Triangle>& hole) {
    std::vector<Edge> edges;
    for (const Triangle& triangle : hole) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Edge edge{triangle[i], triangle[(i + 1) % 3]};
            const auto twin = std::find(edges.begin(), edges.end(), Edge{edge.second, edge.first});
            if (twin == edges.end())
                edges.push_back(edge);
            else
                edges.erase(twin);
        }
    }
    return edges;
}

}  // namespace

std::vector<Triangle> planar_delaunay(const std::vector<Eigen::Vector2d>& points) {
    if (points.size() < 3) return {};
    const std::vector<Eigen::Vector2d> all = framed(points);
    const auto at = [&](int i) -> const Eigen::Vector2d& {
        return all[static_cast<std::size_t>(i)];
    };
    const auto count = static_cast<int>(points.size());
    std::vector<Triangle> triangles{{count, count + 1, count + 2}};
    for (int i = 0; i < count; ++i) {
        const auto is_double = [&](int earlier) { return (at(earlier) - at(i)).norm() < 1e-9; };
        bool repeats = false;
        for (int earlier = 0; earlier < i; ++earlier) repeats = repeats || is_double(earlier);
        if (repeats) continue;
        const auto kept =
            std::partition(triangles.begin(), triangles.end(), [&](const Triangle& triangle) {
                return !is_within_circle(at(triangle[0]), at(triangle[1]), at(triangle[2]), at(i));
            });
        const std::vector<Triangle> hole(kept, triangles.end());
        triangles.erase(kept, triangles.end());
        for (const auto& [from, to] : rim_of(hole))
            if (turn(at(from), at(to), at(i)) > 0) triangles.push_back({from, to, i});
    }
    std::erase_if(triangles, [&](const Triangle& triangle) {
        return *std::max_element(triangle.begin(), triangle.end()) >= count;
    });
    return triangles;
}

}  // namespace lumi
