#include "calib/adjust/bundle_problem.h"

#include "calib/adjust/gauge.h"
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

std::vector<Rigid3> poses_of(const Capture& capture) {
    std::vector<Rigid3> poses;
    for (const View& view : capture.views) poses.push_back(view.cam_from_world);
    return poses;
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
    return with_principal_point_held(model).held;
}

CameraBlocks camera_blocks(const Capture& capture) { return {poses_of(capture), capture.cameras}; }

void build_bundle_problem(ceres::Problem& problem, Capture& capture, CameraBlocks& cameras,
                          const BundleAdjustmentOptions& options, ceres::LossFunction* loss) {
    add_observations(problem, capture, cameras, loss);
    hold_lenses(problem, capture, cameras, options);
    hold_gauge(problem, poses_of(capture), cameras);
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
