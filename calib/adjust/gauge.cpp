#include "calib/adjust/gauge.h"

namespace lumi {

void hold_gauge(ceres::Problem& problem, const std::vector<Rigid3>& poses, CameraBlocks& cameras) {
    std::vector<std::size_t> used;
    for (std::size_t view = 0; view < poses.size(); ++view) {
        if (problem.HasParameterBlock(cameras.pose(view))) used.push_back(view);
    }
    if (used.empty()) return;
    const std::size_t first = used.front();
    problem.SetParameterBlockConstant(cameras.pose(first));
    const Eigen::Vector3d origin = centre_in_world(poses[first]);
    std::size_t farthest = first;
    double distance = 0;
    for (const std::size_t view : used) {
        const double here = (centre_in_world(poses[view]) - origin).norm();
        if (here > distance) {
            distance = here;
            farthest = view;
        }
    }
    if (farthest == first) return;
    // The coordinate along which the two cameras differ most sets the scale most firmly.
    int axis = 0;
    (poses[farthest] * origin).cwiseAbs().maxCoeff(&axis);
    problem.SetManifold(cameras.pose(farthest), new_pose_manifold_without(axis));
}

}  // namespace lumi
