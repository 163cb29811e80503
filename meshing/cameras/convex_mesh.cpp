#include "meshing/cameras/convex_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "meshing/cameras/convex_hull.h"

namespace lumi {
namespace {

/// How far the middle of a flat part of the hull is lifted, as a share of its size: points on it
/// become corners, and their hull is the Delaunay triangulation (lifting to a paraboloid).
constexpr double kLift = 1e-7;
/// The apex stands this many camera distances away.
constexpr double kApexDistance = 1e4;

/// How far out the hull is in a direction, in camera distances: the inverse of its gauge.
double reach_of_hull(const std::vector<Eigen::Vector3d>& points,
                     const std::vector<std::array<int, 3>>& faces,
                     const Eigen::Vector3d& direction) {
    double gauge = 0;
    for (const auto& face : faces) {
        const Eigen::Vector3d& a = points[static_cast<std::size_t>(face[0])];
        const Eigen::Vector3d& b = points[static_cast<std::size_t>(face[1])];
        const Eigen::Vector3d& c = points[static_cast<std::size_t>(face[2])];
        const Eigen::Vector3d normal = (b - a).cross(c - a);
        const double height = normal.dot(a);
        if (height > 0) gauge = std::max(gauge, normal.dot(direction) / height);
    }
    return gauge > 0 ? 1.0 / gauge : 0.0;
}

}  // namespace

ConvexShape convex_shape(const CameraStar& star, const std::optional<Eigen::Vector3d>& apex) {
    const double size = largest_distance(star);
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector3d> lifted;
    for (std::size_t i = 0; i < star.directions.size(); ++i) {
        points.push_back(star.distances[i] / size * star.directions[i]);
        lifted.push_back((1.0 - kLift * points.back().squaredNorm()) * points.back());
    }
    if (apex) lifted.push_back(kApexDistance * *apex);

    ConvexShape shape;
    shape.on_hull.assign(points.size(), 0);
    shape.faces = convex_hull_faces(lifted);
    const auto apex_index = static_cast<int>(points.size());
    std::erase_if(shape.faces, [&](const std::array<int, 3>& face) {
        return std::find(face.begin(), face.end(), apex_index) != face.end();
    });
    for (const auto& face : shape.faces) {
        for (const int corner : face) shape.on_hull[static_cast<std::size_t>(corner)] = 1;
    }
    double squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (shape.on_hull[i]) continue;
        const double reach = reach_of_hull(points, shape.faces, star.directions[i]);
        const double share = std::max(0.0, reach / points[i].norm() - 1.0);
        squares += share * share;
        shape.largest_push_share = std::max(shape.largest_push_share, share);
    }
    shape.rms_push_share = std::sqrt(squares / static_cast<double>(points.size()));
    return shape;
}

std::vector<char> on_convex_chain(const CameraStar& star, const Eigen::Vector3d& normal,
                                  bool closed_ring) {
    const double size = largest_distance(star);
    std::vector<Eigen::Vector3d> points;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < star.directions.size(); ++i) {
        const Eigen::Vector3d offset = star.distances[i] / size * star.directions[i];
        const Eigen::Vector3d across = offset - offset.dot(normal) * normal;
        mean += across;
        points.emplace_back((1.0 - kLift * across.squaredNorm()) * across);
    }
    points.emplace_back(kApexDistance * normal);
    points.emplace_back(-kApexDistance * normal);
    if (!closed_ring && mean.norm() > 0) points.emplace_back(-kApexDistance * mean.normalized());
    std::vector<char> on_chain(points.size(), 0);
    for (const auto& face : convex_hull_faces(points)) {
        for (const int corner : face) on_chain[static_cast<std::size_t>(corner)] = 1;
    }
    on_chain.resize(star.directions.size());
    return on_chain;
}

}  // namespace lumi
