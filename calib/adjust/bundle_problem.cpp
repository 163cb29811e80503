#include "calib/adjust/bundle_problem.h"

#include <algorithm>

#include "calib/adjust/reprojection_cost.h"
#include "calib/lens/lens_form.h"

namespace lumi {
namespace {

void hold_lenses(ceres::Problem& problem, const Capture& capture, CameraBlocks& cameras,
                 const BundleAdjustmentOptions& options) {
    for (std::size_t index = 0; index < capture.cameras.size(); ++index) {
        const Camera& camera = capture.cameras[index];
        double* const lens = cameras.lens(index);
        if (!problem.HasParameterBlock(lens)) continue;
        const std::vector<int> constant = constant_lens_parameters(capture, index, options);
        if (constant.empty()) continue;
        if (constant.size() == camera.parameters.size()) {
            problem.SetParameterBlockConstant(lens);
            continue;
        }
        problem.SetManifold(
            lens, new ceres::SubsetManifold(static_cast<int>(camera.parameters.size()), constant));
    }
}

/// Seven degrees of freedom (place, attitude, size of the world) are free: holds the first view,
/// and one coordinate of the view whose centre is farthest from it.
void fix_gauge(ceres::Problem& problem, const Capture& capture, CameraBlocks& cameras) {
    std::vector<std::size_t> used;
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        if (problem.HasParameterBlock(cameras.pose(view))) used.push_back(view);
    }
    if (used.empty()) return;
    const auto pose = [&](std::size_t view) { return capture.views[view].cam_from_world; };
    const std::size_t first = used.front();
    problem.SetParameterBlockConstant(cameras.pose(first));
    const Eigen::Vector3d origin = centre_in_world(pose(first));
    std::size_t farthest = first;
    double distance = 0;
    for (const std::size_t view : used) {
        const double here = (centre_in_world(pose(view)) - origin).norm();
        if (here > distance) {
            distance = here;
            farthest = view;
        }
    }
    if (farthest == first) return;
    // The coordinate along which the two cameras differ most sets the scale most firmly.
    int axis = 0;
    (pose(farthest) * origin).cwiseAbs().maxCoeff(&axis);
    problem.SetManifold(cameras.pose(farthest), new_pose_manifold_without(axis));
}

void add_observations(ceres::Problem& problem, Capture& capture, CameraBlocks& cameras,
                      ceres::LossFunction* loss) {
    for (ScenePoint& point : capture.points) {
        for (const Observation& observation : point.track) {
            const auto view_index = static_cast<std::size_t>(observation.view_index);
            const View& view = capture.views[view_index];
            problem.AddResidualBlock(
                reprojection_cost(camera_of(capture, view).model, observation.pixel).release(),
                loss, cameras.lens(static_cast<std::size_t>(view.camera_index)),
                cameras.pose(view_index), point.position_in_world.data());
        }
    }
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        if (!problem.HasParameterBlock(cameras.pose(view))) continue;
        problem.SetManifold(cameras.pose(view), new_pose_manifold());
    }
}

}  // namespace

std::vector<int> constant_lens_parameters(const Capture& capture, std::size_t camera_index,
                                          const BundleAdjustmentOptions& options) {
    const LensModel model = capture.cameras[camera_index].model;
    if (!options.held_lens_parameters.empty()) return options.held_lens_parameters[camera_index];
    if (!options.refine_lens) return all_held(model).held;
    if (!options.refine_principal_point) return with_principal_point_held(model).held;
    return {};
}

CameraBlocks camera_blocks(const Capture& capture) {
    std::vector<Rigid3> poses;
    for (const View& view : capture.views) poses.push_back(view.cam_from_world);
    return {poses, capture.cameras};
}

void build_bundle_problem(ceres::Problem& problem, Capture& capture, CameraBlocks& cameras,
                          const BundleAdjustmentOptions& options, ceres::LossFunction* loss) {
    add_observations(problem, capture, cameras, loss);
    hold_lenses(problem, capture, cameras, options);
    fix_gauge(problem, capture, cameras);
}

std::shared_ptr<ceres::ParameterBlockOrdering> elimination_order(const ceres::Problem& problem,
                                                                 Capture& capture,
                                                                 CameraBlocks& cameras) {
    auto order = std::make_shared<ceres::ParameterBlockOrdering>();
    std::vector<double*> blocks;
    problem.GetParameterBlocks(&blocks);
    for (double* const block : blocks) order->AddElementToGroup(block, 2);
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        double* const pose = cameras.pose(view);
        if (problem.HasParameterBlock(pose)) order->AddElementToGroup(pose, 1);
    }
    for (ScenePoint& point : capture.points) {
        order->AddElementToGroup(point.position_in_world.data(), 0);
    }
    return order;
}

}  // namespace lumi
