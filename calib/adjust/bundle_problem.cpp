#include "calib/adjust/bundle_problem.h"

#include <algorithm>

#include "calib/adjust/reprojection_cost.h"
#include "calib/lens/lens_form.h"

namespace lumi {
namespace {

void hold_lenses(ceres::Problem& problem, const Capture& capture, LensBlocks& lenses,
                 const BundleAdjustmentOptions& options) {
    for (std::size_t index = 0; index < capture.cameras.size(); ++index) {
        const Camera& camera = capture.cameras[index];
        double* const lens = lenses.of(static_cast<int>(index));
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
void fix_gauge(ceres::Problem& problem, Capture& capture) {
    const auto is_used = [&](View& view) {
        return problem.HasParameterBlock(view.cam_from_world.translation.data());
    };
    const auto first = std::find_if(capture.views.begin(), capture.views.end(), is_used);
    if (first == capture.views.end()) return;
    problem.SetParameterBlockConstant(first->cam_from_world.rotation.coeffs().data());
    problem.SetParameterBlockConstant(first->cam_from_world.translation.data());
    const Eigen::Vector3d origin = centre_in_world(first->cam_from_world);
    View* farthest = nullptr;
    double distance = 0;
    for (View& view : capture.views) {
        if (&view == &*first || !is_used(view)) continue;
        const double here = (centre_in_world(view.cam_from_world) - origin).norm();
        if (here > distance) {
            distance = here;
            farthest = &view;
        }
    }
    if (farthest == nullptr) return;
    // The coordinate along which the two cameras differ most sets the scale most firmly.
    const Rigid3 first_from_world = first->cam_from_world;
    const Eigen::Vector3d difference = farthest->cam_from_world * centre_in_world(first_from_world);
    int axis = 0;
    difference.cwiseAbs().maxCoeff(&axis);
    problem.SetManifold(farthest->cam_from_world.translation.data(),
                        new ceres::SubsetManifold(3, {axis}));
}

void add_observations(ceres::Problem& problem, Capture& capture, LensBlocks& lenses,
                      ceres::LossFunction* loss) {
    for (ScenePoint& point : capture.points) {
        for (const Observation& observation : point.track) {
            View& view = capture.views[static_cast<std::size_t>(observation.view_index)];
            const LensModel model = camera_of(capture, view).model;
            problem.AddResidualBlock(
                reprojection_cost(model, observation.pixel).release(), loss,
                lenses.of(view.camera_index), view.cam_from_world.rotation.coeffs().data(),
                view.cam_from_world.translation.data(), point.position_in_world.data());
        }
    }
    for (View& view : capture.views) {
        double* const rotation = view.cam_from_world.rotation.coeffs().data();
        if (problem.HasParameterBlock(rotation)) {
            problem.SetManifold(rotation, new ceres::EigenQuaternionManifold);
        }
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

void build_bundle_problem(ceres::Problem& problem, Capture& capture, LensBlocks& lenses,
                          const BundleAdjustmentOptions& options, ceres::LossFunction* loss) {
    add_observations(problem, capture, lenses, loss);
    hold_lenses(problem, capture, lenses, options);
    fix_gauge(problem, capture);
}

std::shared_ptr<ceres::ParameterBlockOrdering> elimination_order(const ceres::Problem& problem,
                                                                 Capture& capture) {
    auto order = std::make_shared<ceres::ParameterBlockOrdering>();
    std::vector<double*> blocks;
    problem.GetParameterBlocks(&blocks);
    for (double* const block : blocks) order->AddElementToGroup(block, 2);
    for (View& view : capture.views) {
        for (double* const block : {view.cam_from_world.rotation.coeffs().data(),
                                    view.cam_from_world.translation.data()}) {
            if (problem.HasParameterBlock(block)) order->AddElementToGroup(block, 1);
        }
    }
    for (ScenePoint& point : capture.points) {
        order->AddElementToGroup(point.position_in_world.data(), 0);
    }
    return order;
}

}  // namespace lumi
