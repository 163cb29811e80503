#include "calib/boards/board_calibration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "calib/boards/board_outliers.h"
#include "calib/boards/board_pose.h"
#include "calib/boards/board_start.h"
#include "calib/boards/calibration_evidence.h"
#include "calib/boards/disc_bias.h"
#include "calib/lens/lens_support.h"

namespace lumi {
namespace {

void expect_enough(const BoardViews& board) {
    constexpr std::size_t kLeastViews = 3;
    std::size_t points = 0;
    for (const BoardView& view : board.views) points += view.points.size();
    const std::size_t unknowns = 4 + 6 * board.views.size();
    if (board.views.size() >= kLeastViews && 2 * points > unknowns) return;
    throw Error(ErrorKind::kDegenerateCapture, "E-BOARDS-TOOFEW",
                "a board is seen in " + std::to_string(board.views.size()) + " photographs (" +
                    std::to_string(points) + " points): too few for a lens, " +
                    std::to_string(kLeastViews) + " are the least",
                "photograph the board ten to twenty times, tilted by 20 to 50 degrees in different "
                "directions, also in the corners of the picture");
}

/// The part of a start that has poses, in a richer model.
std::optional<CleanedBoard> cleaned_from(const BoardViews& board, LensModel start_model,
                                         LensModel model) {
    const auto start = start_of_calibration(board, start_model);
    if (!start) return std::nullopt;
    BoardViews posed = board;
    posed.views.clear();
    BoardSolution solution;
    solution.form = all_free(model);
    solution.lens = in_model(start->lens, model);
    solution.size_per_pitch = board.size_per_pitch;
    std::vector<LeftOut> left_out;
    for (std::size_t index = 0; index < board.views.size(); ++index) {
        if (start->cam_from_board[index]) {
            posed.views.push_back(board.views[index]);
            solution.cam_from_board.push_back(*start->cam_from_board[index]);
        } else {
            left_out.push_back({board.views[index].photograph, "E-BOARD-NOPOSE",
                                "its points do not tell where the board stands"});
        }
    }
    CleanedBoard cleaned = without_outliers(posed, solution);
    cleaned.left_out.insert(cleaned.left_out.begin(), left_out.begin(), left_out.end());
    return cleaned;
}

/// Where perspective or fisheye explains the photographs better, and what belongs to them.
CleanedBoard best_cleaned(const BoardViews& board, const BoardCalibrationOptions& options) {
    const bool tries_fisheye = std::find(options.models.begin(), options.models.end(),
                                         LensModel::kOpenCvFisheye) != options.models.end();
    const bool tries_perspective = !tries_fisheye || options.models.size() > 1;
    std::optional<CleanedBoard> best;
    double best_score = 0;
    const auto consider = [&](std::optional<CleanedBoard> cleaned) {
        if (!cleaned || cleaned->board.views.empty()) return;
        // What is thrown away must not make a model better than one that explains everything.
        const double kept = static_cast<double>(cleaned->board.views.size()) /
                            static_cast<double>(board.views.size());
        const double score = robust_sigma_px(cleaned->board, cleaned->solution) / (kept * kept);
        if (!std::isfinite(score) || (best && score >= best_score)) return;
        best_score = score;
        best = std::move(cleaned);
    };
    if (tries_perspective) {
        consider(cleaned_from(board, LensModel::kSimplePinhole, LensModel::kOpenCv));
    }
    if (tries_fisheye) {
        consider(cleaned_from(board, LensModel::kOpenCvFisheye, LensModel::kOpenCvFisheye));
    }
    if (!best) {
        throw Error(ErrorKind::kDegenerateCapture, "E-BOARDS-NOSTART",
                    "no focal length explains the board in half of the photographs",
                    "check that all photographs show one flat board, taken with one lens at one "
                    "zoom");
    }
    return std::move(*best);
}

LensTrial trial_of(const BoardViews& board, const LensFit& fit) {
    LensTrial trial;
    trial.form = fit.solution.form;
    trial.lens = fit.solution.lens;
    trial.sigma.assign(trial.lens.parameters.size(), 0.0);
    trial.residual_sum_px2 = fit.residual_sum_px2;
    trial.residuals = fit.residuals;
    if (!fit.is_usable) {
        trial.residual_sum_px2 = std::numeric_limits<double>::infinity();
        trial.not_predicted = "the fit failed";
        return trial;
    }
    trial.not_predicted = fault_within(board, fit.solution.lens);
    if (!trial.not_predicted.empty()) return trial;
    const std::vector<ReducedView> views = reduced_views(board, fit.solution);
    const LensCertainty certainty = lens_certainty(views, fit.solution.form);
    if (certainty.covariance.size() == 0) {
        trial.not_predicted = "not determined";
        return trial;
    }
    for (std::size_t index = 0; index < trial.sigma.size(); ++index) {
        const auto diagonal = static_cast<Eigen::Index>(index);
        trial.sigma[index] = std::sqrt(certainty.covariance(diagonal, diagonal));
    }
    trial.folds = held_out_photographs(views);
    if (trial.folds.empty()) trial.not_predicted = "not determined without every photograph";
    return trial;
}

BoardSolution in_form(const BoardSolution& solution, const LensForm& form, const Camera& start) {
    BoardSolution result = solution;
    result.form = form;
    result.lens = start;
    return result;
}

struct FittedModels {
    LensChoice choice;
    std::vector<BoardSolution> solutions;  ///< In the order of the models that were asked for.
};

/// Every model, each from the simpler one before it.
FittedModels fit_models(const CleanedBoard& cleaned, const BoardCalibrationOptions& options,
                        Progress& progress) {
    std::vector<LensTrial> trials;
    FittedModels fitted;
    BoardSolution nearest = cleaned.solution;
    for (const LensModel model : options.models) {
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
    fitted.choice = choose_lens(std::move(trials));
    return fitted;
}

const BoardSolution& chosen_solution(const FittedModels& fitted) {
    return *std::find_if(fitted.solutions.begin(), fitted.solutions.end(),
                         [&](const BoardSolution& solution) {
                             return solution.form == fitted.choice.choice().form;
                         });
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

/// Without the parameters that measurement cannot tell from nothing, as far as photographs that
/// took no part are predicted as well without them. Nothing puts a principal point in the middle
/// of the picture by right: holding it there is a step of its own.
BoardSolution supported(const BoardViews& board, const BoardSolution& solution,
                        std::vector<std::string>& dropped) {
    const LensCertainty certainty = lens_certainty(reduced_views(board, solution), solution.form);
    if (certainty.covariance.size() == 0) return solution;
    const SupportedLens left = supported_lens(solution.lens, solution.form, certainty.covariance);
    if (left.form == solution.form) return solution;
    std::vector<BoardSolution> candidates{solution};
    const LensForm with_centre = with_principal_point_free(left.form);
    if (with_centre != left.form && with_centre != solution.form) {
        const auto fitted = refitted(board, solution, with_centre, left.start);
        if (fitted) candidates.push_back(*fitted);
    }
    if (const auto fitted = refitted(board, solution, left.form, left.start)) {
        candidates.push_back(*fitted);
    }
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
    const LensForm chosen = choose_lens(std::move(trials)).choice().form;
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

std::vector<LensParameter> parameters_of(const BoardSolution& solution,
                                         const LensCertainty& certainty, std::size_t views) {
    std::vector<LensParameter> parameters;
    const std::vector<std::string> names = parameter_names(solution.lens.model);
    // The disagreement between photographs is measured on so many differences.
    const double freedom =
        static_cast<double>(views - 1) * std::max(1, free_parameters(solution.form));
    const double quantile =
        boost::math::quantile(boost::math::complement(boost::math::students_t(freedom), 0.025));
    for (std::size_t index = 0; index < names.size(); ++index) {
        const auto diagonal = static_cast<Eigen::Index>(index);
        const double value = solution.lens.parameters[index];
        const double sigma = std::sqrt(certainty.covariance(diagonal, diagonal));
        parameters.push_back(
            {names[index], value, sigma, value - quantile * sigma, value + quantile * sigma});
    }
    return parameters;
}

void expect_known_focal_length(const CleanedBoard& cleaned, const BoardSolution& solution,
                               const LensCertainty& certainty, double max_uncertainty) {
    const bool is_determined = certainty.covariance.size() > 0;
    const double uncertainty =
        is_determined ? std::sqrt(certainty.covariance(0, 0)) / solution.lens.parameters[0] : 1.0;
    double steepest_deg = 0;
    for (std::size_t index = 0; index < cleaned.board.views.size(); ++index) {
        steepest_deg = std::max(steepest_deg,
                                board_tilt_deg(cleaned.board.views[index], solution.size_per_pitch,
                                               solution.cam_from_board[index]));
    }
    constexpr double kLeastTilt_deg = 5.0;
    if (is_determined && uncertainty <= max_uncertainty && steepest_deg >= kLeastTilt_deg) return;
    throw Error(
        ErrorKind::kDegenerateCapture, "E-BOARDS-FOCAL",
        "these photographs do not tell the focal length: the board is turned by at most " +
            std::to_string(std::lround(steepest_deg)) + " degrees in " +
            std::to_string(cleaned.board.views.size()) + " photographs, and " +
            (is_determined ? "the focal length is uncertain by " +
                                 std::to_string(std::lround(100 * uncertainty)) + " %"
                           : "the equations have no single solution"),
        "add photographs with the board tilted by 20 to 50 degrees, left, right, up and down");
}

}  // namespace

BoardCalibration calibrate_boards(const BoardViews& board, const BoardCalibrationOptions& options,
                                  Progress& progress) {
    expect_enough(board);
    progress.begin("calibrating", options.models.size() + 2);
    CleanedBoard cleaned = best_cleaned(board, options);
    expect_enough(cleaned.board);
    progress.advance();
    if (board.are_discs) {
        const BoardViews seen = cleaned.board;
        constexpr int kRounds = 3;
        for (int round = 0; round < kRounds; ++round) {
            cleaned.board = without_disc_bias(seen, cleaned.solution);
            cleaned.solution = fit_lens(cleaned.board, cleaned.solution).solution;
        }
    }
    FittedModels fitted = fit_models(cleaned, options, progress);
    BoardCalibration result;
    const BoardSolution solution =
        supported(cleaned.board, chosen_solution(fitted), result.dropped);
    const std::vector<ReducedView> reduced = reduced_views(cleaned.board, solution);
    result.certainty = lens_certainty(reduced, solution.form);
    expect_known_focal_length(cleaned, solution, result.certainty, options.max_focal_uncertainty);
    result.lens = solution.lens;
    for (double& value : result.lens.parameters) value += 0.0;  // No "-0" where one is held.
    result.form = solution.form;
    result.choice = std::move(fitted.choice);
    result.size_per_pitch = solution.size_per_pitch;
    result.parameters = parameters_of(solution, result.certainty, cleaned.board.views.size());
    result.left_out = cleaned.left_out;
    result.removed_points = cleaned.removed_points;
    add_evidence(cleaned.board, solution, held_out_photographs(reduced), result);
    progress.advance();
    return result;
}

}  // namespace lumi
