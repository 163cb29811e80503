#include "calib/adjust/held_out_views.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <set>

#include "calib/adjust/camera_blocks.h"
#include "calib/adjust/quiet_solver.h"
#include "calib/adjust/reprojection_cost.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

std::vector<int> views_of_camera(const Capture& capture, int camera_index) {
    std::vector<int> views;
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        if (capture.views[view].camera_index == camera_index) {
            views.push_back(static_cast<int>(view));
        }
    }
    return views;
}

/// A point and where the held-out view saw it.
struct Sighting {
    Eigen::Vector3d position_in_world;
    Eigen::Vector2d pixel;
};

/// What every fold must count alike: an error beyond the limit, or none at all, counts the limit.
double counted_px2(const Camera& lens, const Rigid3& pose, const Sighting& sighting,
                   double max_error_px) {
    const double limit_px2 = max_error_px * max_error_px;
    const auto pixel = project(lens, pose * sighting.position_in_world);
    if (!pixel) return limit_px2;
    const double squared = (*pixel - sighting.pixel).squaredNorm();
    return squared <= limit_px2 ? squared : limit_px2;
}

/// The pose from which the sightings fit best, under a robust loss.
Rigid3 resected(const Camera& lens, Rigid3 pose, std::vector<Sighting>& sightings) {
    ceres::Problem::Options problem_options;
    problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::HuberLoss loss(1.0);
    ceres::Problem problem(problem_options);
    std::vector<double> parameters = lens.parameters;
    PoseBlock block = pose_block(pose);
    for (Sighting& sighting : sightings) {
        // Behind the camera a point has no derivative.
        if (!project(lens, pose * sighting.position_in_world)) continue;
        double* const position = sighting.position_in_world.data();
        problem.AddResidualBlock(reprojection_cost(lens.model, sighting.pixel).release(), &loss,
                                 parameters.data(), block.data(), position);
        problem.SetParameterBlockConstant(position);
    }
    constexpr int kMinSightings = 4;
    if (problem.NumResidualBlocks() < kMinSightings) return pose;
    problem.SetParameterBlockConstant(parameters.data());
    problem.SetManifold(block.data(), new_pose_manifold());
    ceres::Solver::Options solver = quiet_solver_options();
    solver.linear_solver_type = ceres::DENSE_QR;
    solver.max_num_iterations = 20;
    solver.function_tolerance = 1e-8;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    return pose_of(block);
}

/// `fitted` without the observations of some views, and where those views saw what is left.
struct Split {
    Capture rest;
    std::vector<std::vector<Sighting>> sightings;  ///< By held-out view, as they were given.
    std::vector<std::vector<std::size_t>> points;  ///< Their points, by index into `rest`.
};

Split split(const Capture& fitted, const std::vector<int>& held_out) {
    Split result{{fitted.cameras, fitted.views, {}}, {}, {}};
    result.sightings.resize(held_out.size());
    result.points.resize(held_out.size());
    for (const ScenePoint& point : fitted.points) {
        ScenePoint rest = point;
        std::erase_if(rest.track, [&](const Observation& seen) {
            return std::binary_search(held_out.begin(), held_out.end(), seen.view_index);
        });
        std::set<int> views;
        for (const Observation& seen : rest.track) views.insert(seen.view_index);
        if (views.size() < 2) continue;
        for (const Observation& seen : point.track) {
            const auto found = std::lower_bound(held_out.begin(), held_out.end(), seen.view_index);
            if (found == held_out.end() || *found != seen.view_index) continue;
            const auto position = static_cast<std::size_t>(found - held_out.begin());
            result.sightings[position].push_back({point.position_in_world, seen.pixel});
            result.points[position].push_back(result.rest.points.size());
        }
        result.rest.points.push_back(std::move(rest));
    }
    return result;
}

HeldOutFold sum_of(const Camera& lens, const Rigid3& pose, const std::vector<Sighting>& sightings,
                   double max_error_px) {
    HeldOutFold fold;
    for (const Sighting& sighting : sightings) {
        fold.squared_error_px2 += counted_px2(lens, pose, sighting, max_error_px);
        fold.residuals += 2;
    }
    return fold;
}

}  // namespace

std::vector<HeldOutFold> predict_held_out_views(const Capture& fitted, int camera_index,
                                                const BundleAdjustmentOptions& adjustment,
                                                const HeldOutViewsOptions& options, int threads,
                                                Progress& progress) {
    const std::vector<int> views = views_of_camera(fitted, camera_index);
    const int folds = std::min(options.folds, static_cast<int>(views.size()));
    std::vector<HeldOutFold> result(views.size());
    parallel_for(folds, threads, [&](int fold) {
        std::vector<int> held_out;
        std::vector<std::size_t> positions;
        for (std::size_t index = 0; index < views.size(); ++index) {
            if (static_cast<int>(index) % folds != fold) continue;
            held_out.push_back(views[index]);
            positions.push_back(index);
        }
        Split parts = split(fitted, held_out);
        if (parts.rest.points.empty()) return;
        fit_bundle(parts.rest, adjustment, progress);
        for (std::size_t index = 0; index < held_out.size(); ++index) {
            std::vector<Sighting>& sightings = parts.sightings[index];
            for (std::size_t i = 0; i < sightings.size(); ++i) {
                sightings[i].position_in_world =
                    parts.rest.points[parts.points[index][i]].position_in_world;
            }
            const View& view = fitted.views[static_cast<std::size_t>(held_out[index])];
            const Camera& lens = camera_of(parts.rest, view);
            const Rigid3 pose = resected(lens, view.cam_from_world, sightings);
            result[positions[index]] = sum_of(lens, pose, sightings, options.max_error_px);
        }
    });
    return result;
}

std::vector<HeldOutFold> fitted_views(const Capture& fitted, int camera_index,
                                      const HeldOutViewsOptions& options) {
    const std::vector<int> views = views_of_camera(fitted, camera_index);
    const int folds = std::min(options.folds, static_cast<int>(views.size()));
    std::vector<HeldOutFold> result(views.size());
    for (int fold = 0; fold < folds; ++fold) {
        std::vector<int> held_out;
        for (std::size_t index = 0; index < views.size(); ++index) {
            if (static_cast<int>(index) % folds == fold) held_out.push_back(views[index]);
        }
        const Split parts = split(fitted, held_out);
        for (std::size_t index = 0; index < held_out.size(); ++index) {
            const View& view = fitted.views[static_cast<std::size_t>(held_out[index])];
            const auto position = std::lower_bound(views.begin(), views.end(), held_out[index]);
            result[static_cast<std::size_t>(position - views.begin())] =
                sum_of(camera_of(fitted, view), view.cam_from_world, parts.sightings[index],
                       options.max_error_px);
        }
    }
    return result;
}

}  // namespace lumi
