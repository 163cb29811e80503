#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// The plane of a face: `outward_normal` has length one, `distance` is that of the scene centre,
/// positive on the inner side.
struct FacePlane {
    Eigen::Vector3d outward_normal = Eigen::Vector3d::Zero();
    double distance = 0.0;
};

/// The plane of one face, relative to the mesh's scene centre.
[[nodiscard]] FacePlane face_plane(const CameraMesh& mesh, const CameraMesh::Face& face);

/// Planes of the mesh's faces, relative to its scene centre. In the words of the method
/// (m . (x - centre) = 1) each stands for m = outward_normal / distance.
///
/// The kernel of the mesh is the set of points on the inner side of all of them: a line that meets
/// the kernel enters through exactly one face, so its weights exist, are unique and continuous.
[[nodiscard]] std::vector<FacePlane> face_planes(const CameraMesh& mesh);

/// Radius of the largest ball about the scene centre within the kernel; 0 when the centre is not in
/// it, infinite without faces.
[[nodiscard]] double kernel_radius(const std::vector<FacePlane>& planes);

/// The largest m . (x - centre) over the faces: at most 1 exactly for points in the kernel, and the
/// inverse of the factor by which the kernel must shrink about its centre to touch the point.
/// Infinite when the scene centre itself is not inside.
[[nodiscard]] double kernel_gauge(const std::vector<FacePlane>& planes,
                                  const Eigen::Vector3d& point_from_centre);

/// The least distance of a point to the face planes, positive inside the kernel. Unlike the gauge
/// it does not depend on where in the kernel the centre is.
[[nodiscard]] double kernel_clearance(const std::vector<FacePlane>& planes,
                                      const Eigen::Vector3d& point_from_centre);

/// The same the other way round: the least distance of any of the points to one plane, infinite
/// without points.
[[nodiscard]] double face_clearance(const FacePlane& plane,
                                    const std::vector<Eigen::Vector3d>& points_from_centre);

}  // namespace lumi
