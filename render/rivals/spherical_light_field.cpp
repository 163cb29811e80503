#include "render/rivals/spherical_light_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace lumi {
namespace {

constexpr double kDistanceInRadii = 20.0;

/// An icosahedron whose triangles are halved along each side, its corners on the unit sphere.
struct Sphere {
    std::vector<Eigen::Vector3d> corners;
    std::vector<CameraMesh::Face> faces;
};

Sphere icosahedron() {
    const double golden = 0.5 * (1 + std::sqrt(5.0));
    Sphere sphere;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-golden, golden})
            for (int axis = 0; axis < 3; ++axis)
                sphere.corners.push_back((a * Eigen::Vector3d::Unit((axis + 1) % 3) +
                                          b * Eigen::Vector3d::Unit((axis + 2) % 3))
                                             .normalized());
    const auto are_neighbours = [&](int i, int j) {
        return sphere.corners[static_cast<std::size_t>(i)].dot(
                   sphere.corners[static_cast<std::size_t>(j)]) > 0.4;
    };
    for (int i = 0; i < 12; ++i)
        for (int j = i + 1; j < 12; ++j)
            for (int k = j + 1; k < 12; ++k)
                if (are_neighbours(i, j) && are_neighbours(j, k) && are_neighbours(i, k))
                    sphere.faces.push_back({i, j, k});
    return sphere;
}

Sphere halved(const Sphere& coarse) {
    Sphere fine{coarse.corners, {}};
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), 0);
        if (is_new) {
            found->second = static_cast<int>(fine.corners.size());
            const Eigen::Vector3d sum = fine.corners[static_cast<std::size_t>(a)] +
                                        fine.corners[static_cast<std::size_t>(b)];
            fine.corners.push_back(sum.normalized());
        }
        return found->second;
    };
    for (const auto& [a, b, c] : coarse.faces) {
        const int ab = middle(a, b);
        const int bc = middle(b, c);
        const int ca = middle(c, a);
        for (const CameraMesh::Face& face :
             {CameraMesh::Face{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            fine.faces.push_back(face);
    }
    return fine;
}

Rigid3 looking_along(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d down =
        std::abs(direction.z()) < 0.9 ? Eigen::Vector3d(0, 0, -1) : Eigen::Vector3d(0, 1, 0);
    Rigid3 pose;
    pose.rotation = Eigen::Quaterniond(rotation_with_axis(direction, down));
    pose.translation = -(pose.rotation * from);
    return pose;
}

}  // namespace

int subdivisions_for(std::size_t pictures) {
    const auto off = [&](int subdivisions) {
        return std::abs(10.0 * std::pow(4.0, subdivisions) + 2 - static_cast<double>(pictures));
    };
    int best = 0;
    while (off(best + 1) < off(best)) ++best;
    return best;
}

LightFieldLayout spherical_light_field(const Lumigraph& source, const SphericalOptions& options) {
    Sphere sphere = icosahedron();
    for (int i = 0; i < options.subdivisions; ++i) sphere = halved(sphere);
    LightFieldLayout layout;
    layout.mesh.construction = MeshConstruction::kClosed;
    const Eigen::Vector3d centre = source.mesh.scene_centre_in_world;
    layout.mesh.scene_centre_in_world = centre;
    const Eigen::Vector2d half_size = seen_half_size(source);
    const double radius = std::sqrt(half_size.x() * half_size.y());
    const Camera camera =
        pinhole_camera(options.size_px, options.size_px, 0.5 * kDistanceInRadii * options.size_px);
    for (const Eigen::Vector3d& direction : sphere.corners) {
        const Eigen::Vector3d at = centre + kDistanceInRadii * radius * direction;
        layout.mesh.vertices.push_back({at, static_cast<int>(layout.eyes.size())});
        layout.eyes.push_back({camera, looking_along(at, -direction)});
    }
    for (CameraMesh::Face face : sphere.faces) {
        const auto corner = [&](std::size_t i) {
            return sphere.corners[static_cast<std::size_t>(face[i])];
        };
        if (corner(0).cross(corner(1)).dot(corner(2)) < 0) std::swap(face[1], face[2]);
        layout.mesh.faces.push_back(face);
    }
    return layout;
}

}  // namespace lumi
