#include "meshing/cameras/border.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace lumi {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Edges that only one face has, in the direction in which that face runs through them.
std::vector<std::pair<int, int>> border_edges(const CameraMesh& mesh) {
    std::set<std::pair<int, int>> directed;
    for (const CameraMesh::Face& face : mesh.faces) {
        for (std::size_t i = 0; i < 3; ++i) directed.emplace(face[i], face[(i + 1) % 3]);
    }
    std::vector<std::pair<int, int>> border;
    for (const auto& [from, to] : directed) {
        if (!directed.contains({to, from})) border.emplace_back(from, to);
    }
    return border;
}

Eigen::Vector3d mean_direction(const std::vector<CameraDirection>& cameras) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const CameraDirection& camera : cameras) sum += camera.direction;
    return sum.norm() > 1e-9 ? Eigen::Vector3d(sum.normalized()) : cameras.front().direction;
}

/// Directions in which a border camera is repeated: further and further away from the middle of the
/// capture, almost to the opposite side.
std::vector<Eigen::Vector3d> skirt_directions(const Eigen::Vector3d& middle,
                                              const Eigen::Vector3d& direction, int rings) {
    constexpr double kFarthestRad = 170 * kDegree;
    const Eigen::Vector3d across = middle.cross(direction);
    const double polar = std::atan2(across.norm(), middle.dot(direction));
    const Eigen::Vector3d axis =
        across.norm() > 1e-9 ? Eigen::Vector3d(across.normalized()) : orthogonal_unit(middle);
    std::vector<Eigen::Vector3d> result;
    for (int ring = 1; ring <= rings; ++ring) {
        const double turned =
            polar + (std::max(kFarthestRad, polar) - polar) * ring / static_cast<double>(rings);
        result.push_back(Eigen::AngleAxisd(turned, axis) * middle);
    }
    return result;
}

}  // namespace

std::vector<SphericalFace> without_far_side(const std::vector<SphericalFace>& faces,
                                            std::size_t camera_count) {
    std::vector<double> angles;
    for (const SphericalFace& face : faces) angles.push_back(face.cap_angle_rad);
    const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
    std::nth_element(angles.begin(), middle, angles.end());
    const double limit = std::clamp(3 * *middle, 60 * kDegree, 85 * kDegree);

    std::vector<const SphericalFace*> smallest_at(camera_count, nullptr);
    for (const SphericalFace& face : faces) {
        for (const int corner : face.corners) {
            const SphericalFace*& smallest = smallest_at[static_cast<std::size_t>(corner)];
            if (smallest == nullptr || face.cap_angle_rad < smallest->cap_angle_rad) {
                smallest = &face;
            }
        }
    }
    const std::set<const SphericalFace*> needed(smallest_at.begin(), smallest_at.end());
    std::vector<SphericalFace> kept;
    for (const SphericalFace& face : faces) {
        if (face.cap_angle_rad <= limit || needed.contains(&face)) kept.push_back(face);
    }
    return kept;
}

void add_skirt(CameraMesh& mesh, const std::vector<CameraDirection>& cameras) {
    constexpr int kRings = 5;
    constexpr double kRadiusGrowth = 1.15;  // Keeps the chords of the skirt away from the scene.
    const Eigen::Vector3d middle = mean_direction(cameras);
    const std::vector<std::pair<int, int>> border = border_edges(mesh);

    // First virtual vertex of each border vertex; its rings follow one another.
    std::map<int, int> first_virtual;
    for (const auto& [from, to] : border) {
        if (first_virtual.contains(from)) continue;
        first_virtual[from] = static_cast<int>(mesh.vertices.size());
        const CameraDirection& camera = cameras[static_cast<std::size_t>(from)];
        double radius = camera.radius;
        for (const Eigen::Vector3d& direction :
             skirt_directions(middle, camera.direction, kRings)) {
            radius *= kRadiusGrowth;
            mesh.vertices.push_back(
                {mesh.scene_centre_in_world + radius * direction, camera.view_index});
        }
    }
    for (const auto& [from, to] : border) {
        int inner_from = from;
        int inner_to = to;
        for (int ring = 0; ring < kRings; ++ring) {
            const int outer_from = first_virtual.at(from) + ring;
            const int outer_to = first_virtual.at(to) + ring;
            mesh.faces.push_back({inner_to, inner_from, outer_from});
            mesh.faces.push_back({inner_to, outer_from, outer_to});
            inner_from = outer_from;
            inner_to = outer_to;
        }
    }
}

}  // namespace lumi
