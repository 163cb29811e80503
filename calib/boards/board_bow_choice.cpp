#include "calib/boards/board_bow_choice.h"

#include <Eigen/Dense>
#include <algorithm>
#include <iterator>
#include <utility>

#include "calib/boards/board_counting.h"
#include "calib/boards/board_trials.h"
#include "calib/boards/disc_bias.h"
#include "calib/boards/lens_certainty.h"

namespace lumi {
namespace {

/// What a flat fit would predict with a bow, to first order.
LensTrial foreseen_trial(const BoardViews& board, const BoardSolution& flat) {
    BoardSolution bent = flat;
    bent.is_bent = true;
    LensTrial trial;
    trial.form = flat.form;
    trial.lens = flat.lens;
    trial.beside = "bent board";
    trial.parameters_beside = free_parameters_of_board(bent);
    const auto step = step_to_minimum(reduced_views(board, bent));
    if (!step) {
        trial.not_predicted = "not determined";
        return trial;
    }
    for (const ReducedView& view : step->views) {
        trial.residual_sum_px2 += view.residual_sum_px2;
        trial.residuals += view.residuals;
    }
    trial.folds = held_out_photographs(step->views);
    return trial;
}

bool asks_for_bow(const LensTrial& flat, const LensTrial& bent) {
    if (!any_usable(bent.folds)) return false;
    if (!any_usable(flat.folds)) return true;
    const LensChoice pair = choose_lens({flat, bent});
    const auto is_bent = [&](std::size_t trial) { return !pair.trials[trial].beside.empty(); };
    if (!is_bent(pair.best_predicting)) return is_bent(pair.chosen);
    // One alone lets every sixth flat board pass for bent.
    constexpr double kStandardErrors = 2;
    const LensTrial& other = pair.trials[1 - pair.best_predicting];
    return free_parameters(bent) <= free_parameters(flat) ||
           other.excess_px2 > kStandardErrors * other.excess_sigma_px2;
}

/// Whether all three parameters together are as improbable as two standard deviations are of one.
bool is_told_from_nothing(const BoardViews& board, const BoardSolution& bent) {
    const LensCertainty certainty = lens_certainty(reduced_views(board, bent), bent.form);
    if (certainty.of_board.size() == 0) return false;
    const Eigen::Matrix3d covariance = certainty.of_board.bottomRightCorner<3, 3>();
    const Eigen::Map<const Eigen::Vector3d> bow(bent.bow.data());
    constexpr double kChiSquareOfThree = 8.02;
    return bow.dot(covariance.ldlt().solve(bow)) > kChiSquareOfThree;
}

/// Both lists in one, the choice that of `bent`.
FittedModels both(const FittedModels& flat, const FittedModels& bent) {
    FittedModels all = flat;
    all.solutions.insert(all.solutions.end(), bent.solutions.begin(), bent.solutions.end());
    std::vector<LensTrial> trials = flat.choice.trials;
    trials.insert(trials.end(), bent.choice.trials.begin(), bent.choice.trials.end());
    all.choice = choose_lens(std::move(trials));
    const LensTrial& chosen = bent.choice.choice();
    const auto found = std::find_if(
        all.choice.trials.begin(), all.choice.trials.end(), [&](const LensTrial& trial) {
            return trial.form == chosen.form && trial.beside == chosen.beside;
        });
    all.choice.chosen = static_cast<std::size_t>(found - all.choice.trials.begin());
    return all;
}

/// The bow that a flat fit asks for, to first order.
BoardSolution with_foreseen_bow(const BoardViews& board, BoardSolution solution) {
    solution.is_bent = true;
    const auto step = step_to_minimum(reduced_views(board, solution));
    if (!step) return solution;
    const auto size = static_cast<Eigen::Index>(solution.bow.size());
    Eigen::Map<Eigen::Vector3d>(solution.bow.data()) = step->change.tail(size);
    return solution;
}

}  // namespace

void allow_for_bow(CleanedBoard& cleaned, FittedModels& fitted,
                   const std::vector<LensModel>& models, Progress& progress) {
    CleanedBoard bent = cleaned;
    const BoardSolution& flat = chosen_solution(fitted);
    count_alike(bent.board, flat);
    std::vector<LensTrial> foreseen;
    for (const BoardSolution& solution : fitted.solutions) {
        foreseen.push_back(foreseen_trial(bent.board, solution));
    }
    const LensTrial& flat_trial = fitted.choice.choice();
    if (!asks_for_bow(flat_trial, choose_that_explains(std::move(foreseen)).choice())) return;
    bent.solution = with_foreseen_bow(bent.board, flat);
    progress.begin("allowing for a bent board", models.size() + 1);
    const FittedModels with_bow = fit_models(bent, models, progress);
    if (!asks_for_bow(flat_trial, with_bow.choice.choice()) ||
        !is_told_from_nothing(bent.board, chosen_solution(with_bow))) {
        return;
    }
    fitted = both(fitted, with_bow);
    cleaned.board = std::move(bent.board);
    cleaned.solution = chosen_solution(fitted);
}

BoardSolution cleaned_anew(CleanedBoard& cleaned, const BoardSolution& bent) {
    BoardViews whole = cleaned.board;
    for (std::size_t view = 0; view < whole.views.size(); ++view) {
        whole.views[view].points = cleaned.whole_views[view].points;
    }
    if (whole.are_discs) whole = without_disc_bias(whole, bent);
    CleanedBoard again = without_outliers(whole, bent);
    cleaned.board = std::move(again.board);
    cleaned.left_out.insert(cleaned.left_out.end(), again.left_out.begin(), again.left_out.end());
    cleaned.removed_points = again.removed_points;
    cleaned.whole_views = std::move(again.whole_views);
    return fit_lens(cleaned.board, again.solution).solution;
}

}  // namespace lumi
