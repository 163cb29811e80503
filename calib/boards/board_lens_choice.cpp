#include "calib/boards/board_lens_choice.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "calib/boards/board_trials.h"
#include "calib/boards/calibration_evidence.h"
#include "calib/boards/lens_certainty.h"
#include "calib/lens/lens_support.h"

namespace lumi {
namespace {

BoardSolution in_form(const BoardSolution& solution, const LensForm& form, const Camera& start) {
    BoardSolution result = solution;
    result.form = form;
    result.lens = start;
    return result;
}

/// A form with fewer parameters, fitted from `start`; none when that fails.
std::optional<BoardSolution> refitted(const BoardViews& board, const BoardSolution& solution,
                                      const LensForm& form, const Camera& start) {
    const LensFit fit = fit_lens(board, in_form(solution, form, start));
    if (!fit.is_usable || !fault_within(board, fit.solution.lens).empty()) return std::nullopt;
    return fit.solution;
}

/// The form without its hold on the principal point.
LensForm with_principal_point_free(LensForm form) {
    const int cx = *parameter_named(form.model, "cx");
    std::erase_if(form.held, [&](int index) { return index == cx || index == cx + 1; });
    return form;
}

/// Standard deviation of the focal length were it known that pixels are square, which holds for
/// nearly every camera.
double focal_sigma_px(const LensForm& form, const Eigen::MatrixXd& covariance) {
    double variance_px2 = covariance(0, 0);
    if (has_one_focal_length(form.model)) return std::sqrt(variance_px2);
    const double with_difference_px2 = covariance(0, 1) - covariance(0, 0);
    const double difference_px2 = covariance(0, 0) + covariance(1, 1) - 2 * covariance(0, 1);
    if (difference_px2 > 0) {
        variance_px2 -= with_difference_px2 * with_difference_px2 / difference_px2;
    }
    return std::sqrt(std::max(0.0, variance_px2));
}

/// Whether what a fisheye's form holds makes its focal length look known. A board that faces a
/// fisheye tells its focal length and its coefficients together: none of them can be told from
/// nothing, and without some the others would seem certain. Of a perspective lens the coefficients
/// follow from how straight lines bend, at any focal length.
bool rests_on_what_it_holds(const BoardViews& board, const BoardSolution& candidate,
                            double free_focal_sigma_px) {
    if (candidate.form.model != LensModel::kOpenCvFisheye) return false;
    constexpr double kLeastShare = 0.5;
    const LensCertainty certainty = lens_certainty(reduced_views(board, candidate), candidate.form);
    return certainty.covariance.size() == 0 ||
           focal_sigma_px(candidate.form, certainty.covariance) < kLeastShare * free_focal_sigma_px;
}

}  // namespace

FittedModels fit_models(const CleanedBoard& cleaned, const std::vector<LensModel>& models,
                        Progress& progress) {
    std::vector<LensTrial> trials;
    FittedModels fitted;
    BoardSolution nearest = cleaned.solution;
    for (const LensModel model : models) {
        progress.throw_if_interrupted();
        const bool same_family = (model == LensModel::kOpenCvFisheye) ==
                                 (nearest.lens.model == LensModel::kOpenCvFisheye);
        const BoardSolution& from = same_family ? nearest : cleaned.solution;
        const LensFit fit =
            fit_lens(cleaned.board, in_form(from, all_free(model), in_model(from.lens, model)));
        trials.push_back(trial_of(cleaned.board, fit));
        fitted.solutions.push_back(fit.solution);
        if (fit.is_usable && model != LensModel::kOpenCvFisheye) nearest = fit.solution;
        progress.advance();
    }
    fitted.choice = choose_that_explains(std::move(trials));
    return fitted;
}

const BoardSolution& chosen_solution(const FittedModels& fitted) {
    const LensTrial& chosen = fitted.choice.choice();
    return *std::find_if(fitted.solutions.begin(), fitted.solutions.end(),
                         [&](const BoardSolution& solution) {
                             return solution.form == chosen.form &&
                                    free_parameters_of_board(solution) == chosen.parameters_beside;
                         });
}

BoardSolution supported(const BoardViews& board, const BoardSolution& solution,
                        std::vector<std::string>& dropped) {
    const LensCertainty certainty = lens_certainty(reduced_views(board, solution), solution.form);
    if (certainty.covariance.size() == 0) return solution;
    const SupportedLens left = supported_lens(solution.lens, solution.form, certainty.covariance);
    if (left.form == solution.form) return solution;
    const double focal_px = focal_sigma_px(solution.form, certainty.covariance);
    std::vector<BoardSolution> candidates{solution};
    const auto consider = [&](const LensForm& form) {
        const auto fitted = refitted(board, solution, form, left.start);
        if (fitted && !rests_on_what_it_holds(board, *fitted, focal_px)) {
            candidates.push_back(*fitted);
        }
    };
    const LensForm with_centre = with_principal_point_free(left.form);
    if (with_centre != left.form && with_centre != solution.form) consider(with_centre);
    consider(left.form);
    std::vector<LensTrial> trials;
    for (const BoardSolution& candidate : candidates) {
        LensFit fit;
        fit.solution = candidate;
        fit.is_usable = true;
        for (const ReducedView& view : reduced_views(board, candidate)) {
            fit.residual_sum_px2 += view.residual_sum_px2;
            fit.residuals += view.residuals;
        }
        trials.push_back(trial_of(board, fit));
    }
    const LensForm chosen = choose_that_explains(std::move(trials)).choice().form;
    for (const BoardSolution& candidate : candidates) {
        if (candidate.form != chosen) continue;
        const bool keeps_centre = !is_held(chosen, *parameter_named(chosen.model, "cx"));
        const bool is_changed = chosen != solution.form;
        for (const std::string& drop : left.dropped) {
            // What is left may need a model with two focal lengths all the same.
            const bool stays = (keeps_centre && drop.starts_with("cx cy")) ||
                               (!has_one_focal_length(chosen.model) && drop.starts_with("fy - fx"));
            if (is_changed && !stays) dropped.push_back(drop);
        }
        return candidate;
    }
    return solution;
}

}  // namespace lumi
