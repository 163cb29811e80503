#include "calib/boards/lens_fit.h"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "calib/adjust/quiet_solver.h"
#include "calib/boards/board_pose.h"

namespace lumi {
namespace {

constexpr int kBowSize = static_cast<int>(std::tuple_size_v<BoardBow>);

/// A flat board has no block for its bow: what is not estimated costs nothing.
std::unique_ptr<ceres::CostFunction> board_point_cost(const BoardSolution& solution,
                                                      const BoardPoint& point,
                                                      const BoardFrame& frame) {
    return with_lens_model(
        solution.lens.model, [&](auto constant) -> std::unique_ptr<ceres::CostFunction> {
            using Cost = BoardPointCost<decltype(constant)::value>;
            using Flat = ceres::AutoDiffCostFunction<Cost, 2, Cost::kLens, 1, 6>;
            using Bent = ceres::AutoDiffCostFunction<Cost, 2, Cost::kLens, 1, 6, kBowSize>;
            if (!solution.is_bent) return std::make_unique<Flat>(new Cost(point));
            return std::make_unique<Bent>(new Cost(point, frame));
        });
}

bool has_size(const BoardViews& board) { return !board.are_discs && board.size_per_pitch > 0; }

bool estimates_size(const BoardViews& board) { return has_size(board) && !board.is_size_known; }

void hold_parameters(ceres::Problem& problem, BoardSolution& solution, bool is_size_estimated) {
    double* lens = solution.lens.parameters.data();
    if (free_parameters(solution.form) == 0) {
        problem.SetParameterBlockConstant(lens);
    } else if (!solution.form.held.empty()) {
        problem.SetManifold(
            lens, new ceres::SubsetManifold(static_cast<int>(solution.lens.parameters.size()),
                                            solution.form.held));
    }
    if (!is_size_estimated) problem.SetParameterBlockConstant(&solution.size_per_pitch);
}

ceres::Solver::Options solver_options(ceres::Problem& problem, BoardSolution& solution,
                                      const LensFitOptions& options) {
    ceres::Solver::Options result = quiet_solver_options();
    result.linear_solver_type = ceres::DENSE_SCHUR;
    result.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    for (BoardPose& pose : solution.cam_from_board) {
        if (problem.HasParameterBlock(pose.data())) {
            result.linear_solver_ordering->AddElementToGroup(pose.data(), 0);
        }
    }
    result.linear_solver_ordering->AddElementToGroup(solution.lens.parameters.data(), 1);
    result.linear_solver_ordering->AddElementToGroup(&solution.size_per_pitch, 1);
    if (solution.is_bent) result.linear_solver_ordering->AddElementToGroup(solution.bow.data(), 1);
    result.max_num_iterations = options.max_iterations;
    result.function_tolerance = 1e-9;
    result.parameter_tolerance = 1e-10;
    result.gradient_tolerance = 1e-12;
    return result;
}

double residual_sum_px2(const BoardViews& board, const BoardSolution& solution) {
    double sum = 0;
    for (std::size_t index = 0; index < board.views.size(); ++index) {
        const std::vector<Eigen::Vector2d> predicted =
            predicted_px(board.views[index], solution.lens, solution.size_per_pitch,
                         solution.cam_from_board[index], solution.bow);
        for (std::size_t point = 0; point < predicted.size(); ++point) {
            sum += (predicted[point] - board.views[index].points[point].px).squaredNorm();
        }
    }
    return sum;
}

/// Residuals of a view and their derivatives to the shared parameters and to its pose.
struct Linearised {
    Eigen::VectorXd residuals;
    Eigen::MatrixXd to_shared;
    Eigen::MatrixXd to_pose;
};

Linearised linearised(const BoardView& view, const BoardSolution& solution,
                      const std::vector<int>& free, bool is_size_estimated, const BoardPose& pose) {
    const auto rows = static_cast<Eigen::Index>(2 * view.points.size());
    const auto lens_count = static_cast<Eigen::Index>(solution.lens.parameters.size());
    const auto size_column = static_cast<Eigen::Index>(free.size());
    const Eigen::Index bow_column = size_column + (is_size_estimated ? 1 : 0);
    const Eigen::Index shared = bow_column + free_parameters_of_board(solution);
    const BoardFrame frame = frame_of(view);
    Linearised result{Eigen::VectorXd::Zero(rows), Eigen::MatrixXd::Zero(rows, shared),
                      Eigen::MatrixXd::Zero(rows, 6)};
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    RowMajor to_lens(2, lens_count);
    Eigen::Vector2d to_size;
    Eigen::Matrix<double, 2, 6, Eigen::RowMajor> to_pose;
    Eigen::Matrix<double, 2, kBowSize, Eigen::RowMajor> to_bow;
    const std::array<const double*, 4> parameters{solution.lens.parameters.data(),
                                                  &solution.size_per_pitch, pose.data(),
                                                  solution.bow.data()};
    std::array<double*, 4> jacobians{to_lens.data(), to_size.data(), to_pose.data(), to_bow.data()};
    for (Eigen::Index point = 0; 2 * point < rows; ++point) {
        const auto cost =
            board_point_cost(solution, view.points[static_cast<std::size_t>(point)], frame);
        Eigen::Vector2d residual;
        if (!cost->Evaluate(parameters.data(), residual.data(), jacobians.data())) continue;
        result.residuals.segment<2>(2 * point) = residual;
        for (std::size_t column = 0; column < free.size(); ++column) {
            result.to_shared.block<2, 1>(2 * point, static_cast<Eigen::Index>(column)) =
                to_lens.col(free[column]);
        }
        if (is_size_estimated) result.to_shared.block<2, 1>(2 * point, size_column) = to_size;
        if (solution.is_bent) {
            result.to_shared.block<2, kBowSize>(2 * point, bow_column) = to_bow;
        }
        result.to_pose.middleRows<2>(2 * point) = to_pose;
    }
    return result;
}

ReducedView reduced(const Linearised& view) {
    // Projecting by an orthonormal basis keeps full precision, unlike subtracting products.
    const Eigen::HouseholderQR<Eigen::MatrixXd> decomposition(view.to_pose);
    const Eigen::MatrixXd basis =
        decomposition.householderQ() * Eigen::MatrixXd::Identity(view.to_pose.rows(), 6);
    const Eigen::MatrixXd rest = view.to_shared - basis * (basis.transpose() * view.to_shared);
    ReducedView result;
    result.information = rest.transpose() * rest;
    result.gradient = rest.transpose() * view.residuals;
    result.residual_sum_px2 = view.residuals.squaredNorm();
    result.residuals = static_cast<int>(view.residuals.size());
    return result;
}

}  // namespace

int free_parameters_of_board(const BoardSolution& solution) {
    return solution.is_bent ? kBowSize : 0;
}

std::vector<int> free_parameter_indices(const LensForm& form) {
    std::vector<int> indices;
    for (int index = 0; index < static_cast<int>(parameter_count(form.model)); ++index) {
        if (!is_held(form, index)) indices.push_back(index);
    }
    return indices;
}

LensFit fit_lens(const BoardViews& board, const BoardSolution& start,
                 const LensFitOptions& options) {
    LensFit fit;
    fit.solution = start;
    BoardSolution& solution = fit.solution;
    ceres::Problem problem;
    for (std::size_t index = 0; index < board.views.size(); ++index) {
        const BoardFrame frame = frame_of(board.views[index]);
        for (const BoardPoint& point : board.views[index].points) {
            ceres::LossFunction* const loss = options.robust_scale_px > 0
                                                  ? new ceres::CauchyLoss(options.robust_scale_px)
                                                  : nullptr;
            std::vector<double*> blocks{solution.lens.parameters.data(), &solution.size_per_pitch,
                                        solution.cam_from_board[index].data()};
            if (solution.is_bent) blocks.push_back(solution.bow.data());
            problem.AddResidualBlock(board_point_cost(solution, point, frame).release(), loss,
                                     blocks);
            fit.residuals += 2;
        }
    }
    if (!std::isfinite(residual_sum_px2(board, solution))) return fit;
    hold_parameters(problem, solution, estimates_size(board));
    ceres::Solver::Summary summary;
    ceres::Solve(solver_options(problem, solution, options), &problem, &summary);
    fit.iterations = static_cast<int>(summary.iterations.size());
    fit.residual_sum_px2 = residual_sum_px2(board, solution);
    fit.is_usable = summary.IsSolutionUsable() && std::isfinite(fit.residual_sum_px2) &&
                    focal_length_px(solution.lens).minCoeff() > 0;
    return fit;
}

std::vector<ReducedView> reduced_views(const BoardViews& board, const BoardSolution& solution) {
    const std::vector<int> free = free_parameter_indices(solution.form);
    std::vector<ReducedView> result;
    for (std::size_t index = 0; index < board.views.size(); ++index) {
        result.push_back(
            reduced(linearised(board.views[index], solution, free, estimates_size(board),
                               solution.cam_from_board[index])));
    }
    return result;
}

}  // namespace lumi
