#include "meshing/cameras/kernel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace lumi {

FacePlane face_plane(const CameraMesh& mesh, const CameraMesh::Face& face) {
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        corners[corner] = mesh.vertices[static_cast<std::size_t>(face[corner])].position_in_world -
                          mesh.scene_centre_in_world;
    }
    const Eigen::Vector3d normal =
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    return {normal, normal.dot(corners[0])};
}

std::vector<FacePlane> face_planes(const CameraMesh& mesh) {
    std::vector<FacePlane> planes;
    for (const CameraMesh::Face& face : mesh.faces) planes.push_back(face_plane(mesh, face));
    return planes;
}

double kernel_radius(const std::vector<FacePlane>& planes) {
    double radius = std::numeric_limits<double>::infinity();
    for (const FacePlane& plane : planes) radius = std::min(radius, plane.distance);
    return std::max(radius, 0.0);
}

double kernel_gauge(const std::vector<FacePlane>& planes,
                    const Eigen::Vector3d& point_from_centre) {
    double gauge = 0;
    for (const FacePlane& plane : planes) {
        if (!(plane.distance > 0)) return std::numeric_limits<double>::infinity();
        gauge = std::max(gauge, plane.outward_normal.dot(point_from_centre) / plane.distance);
    }
    return gauge;
}

double kernel_clearance(const std::vector<FacePlane>& planes,
                        const Eigen::Vector3d& point_from_centre) {
    double clearance = std::numeric_limits<double>::infinity();
    for (const FacePlane& plane : planes) {
        clearance =
            std::min(clearance, plane.distance - plane.outward_normal.dot(point_from_centre));
    }
    return clearance;
}

double face_clearance(const FacePlane& plane,
                      const std::vector<Eigen::Vector3d>& points_from_centre) {
    double reach = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& point : points_from_centre) {
        reach = std::max(reach, plane.outward_normal.dot(point));
    }
    return plane.distance - reach;
}

}  // namespace lumi
