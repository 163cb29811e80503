#include "meshing/cameras/kernel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace lumi {
namespace {

struct FacePlane {
    Eigen::Vector3d normal;  ///< Outwards, length one.
    double offset = 0.0;

    [[nodiscard]] double height(const Eigen::Vector3d& point) const {
        return normal.dot(point) - offset;
    }
};

FacePlane plane_of(const CameraMesh& mesh, const CameraMesh::Face& face) {
    const auto at = [&](std::size_t corner) -> const Eigen::Vector3d& {
        return mesh.vertices[static_cast<std::size_t>(face[corner])].position_in_world;
    };
    FacePlane plane;
    plane.normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    plane.offset = plane.normal.dot(at(0));
    return plane;
}

}  // namespace

double kernel_radius(const CameraMesh& mesh) {
    double radius = std::numeric_limits<double>::infinity();
    for (const CameraMesh::Face& face : mesh.faces) {
        radius = std::min(radius, -plane_of(mesh, face).height(mesh.scene_centre_in_world));
    }
    return mesh.faces.empty() ? 0.0 : radius;
}

int faces_with_scene_outside(const CameraMesh& mesh,
                             const std::vector<Eigen::Vector3d>& points_in_world,
                             double tolerated_share) {
    const double tolerated = tolerated_share * static_cast<double>(points_in_world.size());
    const auto cuts_the_scene = [&](const CameraMesh::Face& face) {
        const FacePlane plane = plane_of(mesh, face);
        const auto outside =
            std::count_if(points_in_world.begin(), points_in_world.end(),
                          [&](const auto& point) { return plane.height(point) > 0; });
        return static_cast<double>(outside) > tolerated;
    };
    return static_cast<int>(std::count_if(mesh.faces.begin(), mesh.faces.end(), cuts_the_scene));
}

}  // namespace lumi
