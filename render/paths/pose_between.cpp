#include "render/paths/pose_between.h"

namespace lumi {

Rigid3 pose_between(const Rigid3& from, const Rigid3& to, double share) {
    Rigid3 cam_from_world;
    cam_from_world.rotation = from.rotation.slerp(share, to.rotation);
    const Eigen::Vector3d centre =
        (1 - share) * centre_in_world(from) + share * centre_in_world(to);
    cam_from_world.translation = -(cam_from_world.rotation * centre);
    return cam_from_world;
}

}  // namespace lumi
