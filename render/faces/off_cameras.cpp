#include "render/faces/off_cameras.h"

#include <Eigen/Geometry>

namespace lumi {
namespace {

/// Of the distance to the scene's centre.
constexpr double kOffCamera = 1e-6;

}  // namespace

Eye off_cameras(const CameraMesh& mesh, const Eye& eye) {
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    for (const CameraMesh::Vertex& vertex : mesh.vertices) {
        const Eigen::Vector3d behind =
            kOffCamera * (vertex.position_in_world - mesh.scene_centre_in_world);
        if ((eye_in_world - vertex.position_in_world).norm() >= behind.norm()) continue;
        Eye moved = eye;
        moved.cam_from_world.translation =
            -(eye.cam_from_world.rotation * (vertex.position_in_world + behind));
        return moved;
    }
    return eye;
}

}  // namespace lumi
