#include "calib/adjust/bundle_adjustment.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

#include "calib/adjust/bundle_problem.h"
#include "calib/adjust/quiet_solver.h"
#include "calib/adjust/stop_on_interrupt.h"
#include "calib/work/cauchy_scale.h"
#include "calib/work/error.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

/// Of the cost, relative: where one pass ends.
constexpr double kFirstTolerance = 1e-5;
constexpr double kLastTolerance = 1e-6;          ///< Some hundredths of a standard deviation.
constexpr double kLeastSquaresTolerance = 1e-8;  ///< Costs next to nothing where squares converge.
constexpr double kLeastSquares = 0.0;            ///< Instead of the scale of a robust loss.

/// Tells of every iteration.
class AdvanceProgress final : public ceres::IterationCallback {
 public:
    explicit AdvanceProgress(Progress& progress) : progress_(progress) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
        progress_.advance();
        return ceres::SOLVER_CONTINUE;
    }

 private:
    Progress& progress_;
};

/// Removes observations that the estimate contradicts, then points that too few views see.
void remove_outliers(Capture& capture, const BundleAdjustmentOptions& options, double limit_px) {
    for (ScenePoint& point : capture.points) {
        std::erase_if(point.track, [&](const Observation& observation) {
            return !(reprojection_error_px(capture, point, observation) <= limit_px);
        });
    }
    std::erase_if(capture.points, [&](const ScenePoint& point) {
        std::set<int> views;
        for (const Observation& observation : point.track) views.insert(observation.view_index);
        return static_cast<int>(views.size()) < options.min_track_length;
    });
}

bool any_beyond(const Capture& capture, double limit_px) {
    return std::any_of(capture.points.begin(), capture.points.end(), [&](const ScenePoint& point) {
        return std::any_of(
            point.track.begin(), point.track.end(), [&](const Observation& observation) {
                return !(reprojection_error_px(capture, point, observation) <= limit_px);
            });
    });
}

ceres::Solver::Summary solve_pass(Capture& capture, const BundleAdjustmentOptions& options,
                                  double cauchy_scale_px, double tolerance, Progress& progress) {
    ceres::Problem::Options problem_options;
    problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::CauchyLoss cauchy(cauchy_scale_px > 0 ? cauchy_scale_px : 1.0);
    ceres::Problem problem(problem_options);
    CameraBlocks cameras = camera_blocks(capture);
    build_bundle_problem(problem, capture, cameras, options,
                         cauchy_scale_px > 0 ? &cauchy : nullptr);

    constexpr std::size_t kDenseUpToViews = 60;
    AdvanceProgress advance(progress);
    StopOnInterrupt stop(progress);
    ceres::Solver::Options solver = quiet_solver_options();
    solver.linear_solver_type =
        capture.views.size() <= kDenseUpToViews ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
    solver.linear_solver_ordering = elimination_order(problem, capture, cameras);
    solver.max_num_iterations = options.max_iterations;
    solver.function_tolerance = tolerance;
    solver.gradient_tolerance = 1e-10;
    solver.parameter_tolerance = 1e-10;
    solver.callbacks = {&advance, &stop};
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    progress.throw_if_interrupted();
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        capture.views[view].cam_from_world = cameras.solved_pose(view);
    }
    cameras.copy_lenses_to(capture.cameras);
    if (!summary.IsSolutionUsable()) {
        throw Error(ErrorKind::kDegenerateCapture, "E-ADJUST-FAILED",
                    "the bundle adjustment found no solution: " + summary.message,
                    "add photographs between those that are there, or try a simpler lens_model");
    }
    return summary;
}

void expect_shared_points(const Capture& capture) {
    if (!capture.points.empty()) return;
    throw Error(ErrorKind::kDegenerateCapture, "E-ADJUST-FEW",
                "no scene point is left that two photographs agree on",
                "take photographs that overlap by two thirds, and check that they are sharp");
}

}  // namespace

double reprojection_error_px(const Capture& capture, const ScenePoint& point,
                             const Observation& observation) {
    const View& view = capture.views[static_cast<std::size_t>(observation.view_index)];
    const auto pixel =
        project(camera_of(capture, view), view.cam_from_world * point.position_in_world);
    if (!pixel) return std::numeric_limits<double>::infinity();
    return (*pixel - observation.pixel).norm();
}

void update_point_errors(Capture& capture) {
    for (ScenePoint& point : capture.points) {
        double sum = 0;
        for (const Observation& observation : point.track) {
            sum += reprojection_error_px(capture, point, observation);
        }
        point.error_px = point.track.empty() ? 0 : sum / static_cast<double>(point.track.size());
    }
}

std::size_t count_observations(const Capture& capture) {
    std::size_t count = 0;
    for (const ScenePoint& point : capture.points) count += point.track.size();
    return count;
}

double cauchy_scale_px(const Capture& capture) {
    std::vector<double> errors_px;
    for (const ScenePoint& point : capture.points) {
        for (const Observation& seen : point.track) {
            errors_px.push_back(reprojection_error_px(capture, point, seen));
        }
    }
    constexpr double kLeast_px = 0.05;
    // Of two Gaussian coordinates: the median of Rayleigh's distribution.
    const double sigma_px = median_of(std::move(errors_px)) / std::sqrt(2 * std::numbers::ln2);
    return std::max(kLeast_px, kCauchyScalePerSigma * sigma_px);
}

BundleFit fit_bundle(Capture& capture, const BundleAdjustmentOptions& options, Progress& progress) {
    const ceres::Solver::Summary summary =
        solve_pass(capture, options, kLeastSquares, kLeastSquaresTolerance, progress);
    return {2 * summary.final_cost, summary.num_residuals,
            static_cast<int>(summary.iterations.size()),
            summary.termination_type == ceres::CONVERGENCE};
}

void adjust_bundle(Capture& capture, const BundleAdjustmentOptions& options, Progress& progress) {
    progress.begin("adjusting cameras, lens and points together", 0);
    // Points behind a camera have no derivative, and gross errors hide smaller ones: the limit
    // comes down in steps, each after the robust loss has had its say; where there are none, as
    // after another adjustment, the first step is left out.
    constexpr double kNoLimit = std::numeric_limits<double>::max();
    remove_outliers(capture, options, kNoLimit);
    expect_shared_points(capture);
    for (const double limit_factor : {4.0, 1.0}) {
        const double limit_px = limit_factor * options.max_reprojection_error_px;
        if (limit_factor > 1 && !any_beyond(capture, limit_px)) continue;
        solve_pass(capture, options, options.robust_scale_px, kFirstTolerance, progress);
        remove_outliers(capture, options, limit_px);
        expect_shared_points(capture);
    }
    const double scale_px = options.robust_last_pass ? cauchy_scale_px(capture) : kLeastSquares;
    solve_pass(capture, options, scale_px,
               options.robust_last_pass ? kLastTolerance : kLeastSquaresTolerance, progress);
    remove_outliers(capture, options, options.max_reprojection_error_px);
    expect_shared_points(capture);
    update_point_errors(capture);
}

}  // namespace lumi
