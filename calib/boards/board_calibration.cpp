#include "calib/boards/board_calibration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "calib/boards/board_bow_choice.h"
#include "calib/boards/board_copies.h"
#include "calib/boards/board_counting.h"
#include "calib/boards/board_lens_choice.h"
#include "calib/boards/board_outliers.h"
#include "calib/boards/board_pose.h"
#include "calib/boards/board_start.h"
#include "calib/boards/calibration_evidence.h"
#include "calib/boards/disc_bias.h"
#include "calib/work/counted.h"
#include "calib/work/formatted.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

void expect_enough(const BoardViews& board, std::size_t copies) {
    constexpr std::size_t kLeastViews = 3;
    std::size_t points = 0;
    for (const BoardView& view : board.views) points += view.points.size();
    const std::size_t unknowns = 4 + 6 * board.views.size();
    if (board.views.size() >= kLeastViews && 2 * points > unknowns) return;
    throw Error(ErrorKind::kDegenerateCapture, "E-BOARDS-TOOFEW",
                "a board is seen in " + counted(board.views.size(), "photograph") + " (" +
                    counted(points, "point") +
                    (copies > 0 ? "; " + std::to_string(copies) + " more are copies" : "") +
                    "): too few for a lens, " + std::to_string(kLeastViews) + " are the least",
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
    // Tilted boards that disagree have another fault than boards that face the camera.
    constexpr double kStrongDisagreement = 4;
    const bool disagree = is_determined && steepest_deg >= 2 * kLeastTilt_deg &&
                          certainty.disagreement > kStrongDisagreement;
    throw Error(
        ErrorKind::kDegenerateCapture, "E-BOARDS-FOCAL",
        "these photographs do not tell the focal length: the board is turned by at most " +
            std::to_string(std::lround(steepest_deg)) + " degrees in " +
            std::to_string(cleaned.board.views.size()) + " photographs, and " +
            (is_determined ? "the focal length is uncertain by " +
                                 std::to_string(std::lround(100 * uncertainty)) + " %"
                           : "the equations have no single solution") +
            (disagree ? "; photographs disagree about it more than their points' errors explain"
                      : ""),
        disagree ? "check that all show one flat board, taken with one lens at one zoom and focus; "
                   "add photographs with the board tilted by 20 to 50 degrees"
                 : "add photographs with the board tilted by 20 to 50 degrees, left, right, up and "
                   "down");
}

/// Median distance between neighbours of the board, as seen.
double median_pitch_px(const BoardSolution& solution) {
    std::vector<double> pitches_px;
    for (const BoardPose& pose : solution.cam_from_board) {
        const double depth = Eigen::Map<const Eigen::Vector3d>(pose.data() + 3).norm();
        pitches_px.push_back(focal_length_px(solution.lens).mean() / depth);
    }
    return median_of(std::move(pitches_px));
}

/// What is left unexplained, to the distance between neighbours: doubtful beyond what finding
/// points in sharp photographs leaves, as of a print that is bent by a hundredth of its width, and
/// a refusal where what was seen cannot be the board that it was taken for. Returns the doubt, or
/// nothing.
std::string doubt_of_fit(const BoardViews& board, const BoardSolution& solution) {
    const double pitch_px = median_pitch_px(solution);
    const double sigma_px = robust_sigma_px(board, solution);
    constexpr double kDoubtful_px = 0.5;
    constexpr double kDoubtfulShare = 0.005;
    constexpr double kRefused_px = 1.0;
    constexpr double kRefusedShare = 0.015;
    if (sigma_px <= std::max(kDoubtful_px, kDoubtfulShare * pitch_px)) return "";
    const std::string off = "points lie " + formatted("%.1f", sigma_px) +
                            " px (one standard deviation) from where a board with neighbours " +
                            formatted("%.0f", pitch_px) + " px apart would have them";
    if (sigma_px <= std::max(kRefused_px, kRefusedShare * pitch_px)) {
        return off +
               ": if it is bent or was printed stretched, the lens may be farther off than "
               "its intervals say; fix it to a flat plate";
    }
    throw Error(
        ErrorKind::kDegenerateCapture, "E-BOARDS-NOFIT",
        off + ", in " + std::to_string(board.views.size()) + " photographs: too far for a lens",
        std::string(board.is_size_known ? "leave out --square-ratio, so that it is estimated; "
                                        : "") +
            "say what the board is with --board, and check that it is flat, printed without "
            "stretching, and that all photographs were taken with one lens at one zoom");
}

void add_bow(const BoardViews& board, const BoardSolution& solution, BoardCalibration& result) {
    result.bow = bend_of(board, solution.size_per_pitch, solution.bow,
                         result.certainty.of_board.bottomRightCorner<3, 3>());
    constexpr double kLargeShare = 0.03;
    if (result.bow->share_of_width <= kLargeShare) return;
    result.warnings.push_back(
        "bow too large: a board that is bent by " +
        formatted("%.0f", 100 * result.bow->share_of_width) +
        " % of its width is hardly bent evenly, as the fit has it; fix it to a flat plate");
}

/// Which half of the photographs belongs to the lens that is wanted, nobody can tell.
void expect_most_explained(const CleanedBoard& cleaned, std::size_t views) {
    const std::size_t kept = cleaned.board.views.size();
    if (2 * kept > views) return;
    const std::string example =
        cleaned.left_out.empty()
            ? ""
            : " (" + cleaned.left_out.front().name + ": " + cleaned.left_out.front().reason + ")";
    throw Error(ErrorKind::kDegenerateCapture, "E-BOARDS-SEVERAL",
                "no lens explains more than " + std::to_string(kept) + " of " +
                    counted(views, "photograph") + example,
                "check that all show one flat board, sharp, taken with one lens at one zoom; "
                "calibrate each zoom from a folder of its own");
}

}  // namespace

BoardCalibration calibrate_boards(const BoardViews& seen_board,
                                  const BoardCalibrationOptions& options, Progress& progress) {
    BoardViews board = seen_board;
    const std::vector<LeftOut> copies = remove_copies(board);
    set_middles(board);
    expect_enough(board, copies.size());
    progress.begin("calibrating", options.models.size() + 2);
    CleanedBoard cleaned = best_cleaned(board, options);
    expect_most_explained(cleaned, board.views.size());
    expect_enough(cleaned.board, copies.size());
    progress.advance();
    if (board.are_discs) correct_discs(cleaned.board, cleaned.solution);
    FittedModels fitted = fit_models(cleaned, options.models, progress);
    allow_for_bow(cleaned, fitted, options.models, progress);
    BoardSolution chosen = chosen_solution(fitted);
    if (chosen.is_bent) chosen = cleaned_anew(cleaned, chosen);
    BoardCalibration result;
    const BoardSolution solution = supported(cleaned.board, chosen, result.dropped);
    const std::string doubt = doubt_of_fit(cleaned.board, solution);
    if (!doubt.empty()) result.warnings.push_back(doubt);
    const std::vector<ReducedView> reduced = reduced_views(cleaned.board, solution);
    result.certainty = lens_certainty(reduced, solution.form);
    expect_known_focal_length(cleaned, solution, result.certainty, options.max_focal_uncertainty);
    result.lens = solution.lens;
    for (double& value : result.lens.parameters) value += 0.0;  // No "-0" where one is held.
    result.form = solution.form;
    result.choice = std::move(fitted.choice);
    result.size_per_pitch = solution.size_per_pitch;
    if (solution.is_bent) add_bow(cleaned.board, solution, result);
    result.parameters = parameters_of(solution, result.certainty, cleaned.board.views.size());
    result.left_out = copies;
    result.left_out.insert(result.left_out.end(), cleaned.left_out.begin(), cleaned.left_out.end());
    result.removed_points = cleaned.removed_points;
    add_evidence(cleaned.board, solution, held_out_photographs(reduced), result);
    progress.advance();
    return result;
}

}  // namespace lumi
