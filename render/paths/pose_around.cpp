#include "render/paths/pose_around.h"

#include "render/paths/pose_between.h"

namespace lumi {

Rigid3 turned_about(const Eigen::Vector3d& point, const Eigen::Quaterniond& turn,
                    const Rigid3& cam_from_world) {
    Rigid3 turned;
    turned.rotation = cam_from_world.rotation * turn.conjugate();
    const Eigen::Vector3d centre = point + turn * (centre_in_world(cam_from_world) - point);
    turned.translation = -(turned.rotation * centre);
    return turned;
}

Rigid3 pose_around(const Eigen::Vector3d& point, const Rigid3& from, const Rigid3& to,
                   double share) {
    const Eigen::Vector3d to_first = centre_in_world(from) - point;
    const Eigen::Vector3d to_last = centre_in_world(to) - point;
    if (to_first.isZero(0) || to_last.isZero(0)) return pose_between(from, to, share);
    const Eigen::Quaterniond turn = turn_between(to_first, to_last);
    const Rigid3 to_on_one_side = turned_about(point, turn.conjugate(), to);
    return turned_about(point, Eigen::Quaterniond::Identity().slerp(share, turn),
                        pose_between(from, to_on_one_side, share));
}

}  // namespace lumi
