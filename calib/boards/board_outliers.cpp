#include "calib/boards/board_outliers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "calib/boards/board_pose.h"
#include "calib/work/formatted.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

/// Distances between predicted and seen; infinite where the lens cannot see the point.
std::vector<double> distances_px(const BoardViews& board, const BoardSolution& solution,
                                 std::size_t view) {
    std::vector<double> distances;
    const std::vector<Eigen::Vector2d> predicted =
        predicted_px(board.views[view], solution.lens, solution.size_per_pitch,
                     solution.cam_from_board[view], solution.bow);
    for (std::size_t point = 0; point < predicted.size(); ++point) {
        const double distance = (predicted[point] - board.views[view].points[point].px).norm();
        distances.push_back(std::isfinite(distance) ? distance
                                                    : std::numeric_limits<double>::infinity());
    }
    return distances;
}

double rms(const std::vector<double>& distances) {
    double sum = 0;
    for (const double distance : distances) sum += distance * distance;
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, distances.size())));
}

void leave_out(CleanedBoard& cleaned, std::size_t view) {
    const auto at = static_cast<std::ptrdiff_t>(view);
    cleaned.board.views.erase(cleaned.board.views.begin() + at);
    cleaned.whole_views.erase(cleaned.whole_views.begin() + at);
    cleaned.solution.cam_from_board.erase(cleaned.solution.cam_from_board.begin() + at);
}

/// Points beyond `limit_px` go; a view that loses too many goes as a whole.
bool remove_points(CleanedBoard& cleaned, double limit_px) {
    bool has_changed = false;
    BoardViews& board = cleaned.board;
    for (std::size_t index = board.views.size(); index-- > 0;) {
        const std::vector<double> distances = distances_px(board, cleaned.solution, index);
        BoardView& view = board.views[index];
        std::vector<BoardPoint> kept;
        for (std::size_t point = 0; point < distances.size(); ++point) {
            if (distances[point] <= limit_px) kept.push_back(view.points[point]);
        }
        if (kept.size() == view.points.size()) continue;
        has_changed = true;
        constexpr double kLeastShare = 2.0 / 3;
        if (static_cast<double>(kept.size()) <
            kLeastShare * static_cast<double>(view.points.size())) {
            cleaned.left_out.push_back(
                {view.photograph, "E-BOARD-DISAGREES",
                 formatted(
                     "%zu of %zu points lie more than %.2f px off: a bent board, motion, or a "
                     "wrong detection",
                     view.points.size() - kept.size(), view.points.size(), limit_px)});
            leave_out(cleaned, index);
            continue;
        }
        cleaned.removed_points += view.points.size() - kept.size();
        view.points = std::move(kept);
    }
    return has_changed;
}

/// Photographs far worse than the others (at least `floor_px`).
bool remove_views(CleanedBoard& cleaned, double floor_px) {
    BoardViews& board = cleaned.board;
    std::vector<double> view_rms_px;
    for (std::size_t index = 0; index < board.views.size(); ++index) {
        view_rms_px.push_back(rms(distances_px(board, cleaned.solution, index)));
    }
    const double middle_px = median_of(view_rms_px);
    constexpr double kTimesMedian = 4.0;
    const double limit_px = std::max(kTimesMedian * middle_px, floor_px);
    bool has_changed = false;
    for (std::size_t index = board.views.size(); index-- > 0;) {
        if (view_rms_px[index] <= limit_px) continue;
        cleaned.left_out.push_back(
            {board.views[index].photograph, "E-BOARD-DISAGREES",
             formatted(
                 "its points are %.2f px off (the median photograph: %.2f px): blurred, bent, "
                 "or a wrong detection",
                 view_rms_px[index], middle_px)});
        leave_out(cleaned, index);
        has_changed = true;
    }
    return has_changed;
}

}  // namespace

double robust_sigma_px(const BoardViews& board, const BoardSolution& solution) {
    std::vector<double> all;
    for (std::size_t index = 0; index < board.views.size(); ++index) {
        for (const double distance : distances_px(board, solution, index)) all.push_back(distance);
    }
    // The median distance of two independent normal coordinates is 1.1774 standard deviations.
    constexpr double kMedianOfDistance = 1.1774;
    return median_of(std::move(all)) / kMedianOfDistance;
}

CleanedBoard without_outliers(const BoardViews& board, const BoardSolution& start) {
    CleanedBoard cleaned{board, start, {}, 0, board.views};
    constexpr double kFinestScale_px = 1.0;
    for (int round = 0; round < 3; ++round) {
        const double scale_px =
            std::max(kFinestScale_px, 2 * robust_sigma_px(cleaned.board, cleaned.solution));
        cleaned.solution =
            fit_lens(cleaned.board, cleaned.solution, {.robust_scale_px = scale_px}).solution;
        if (scale_px == kFinestScale_px) break;
    }
    constexpr int kMaxRounds = 4;
    constexpr double kStandardDeviations = 5.0;
    constexpr double kLeastLimit_px = 0.1;
    for (int round = 0; round < kMaxRounds && cleaned.board.views.size() > 1; ++round) {
        const double sigma_px = robust_sigma_px(cleaned.board, cleaned.solution);
        const double limit_px = std::max(kLeastLimit_px, kStandardDeviations * sigma_px);
        bool has_changed = remove_points(cleaned, limit_px);
        if (cleaned.board.views.empty()) break;
        has_changed |= remove_views(cleaned, limit_px);
        if (!has_changed || cleaned.board.views.empty()) break;
        cleaned.solution =
            fit_lens(cleaned.board, cleaned.solution, {.robust_scale_px = kFinestScale_px})
                .solution;
    }
    return cleaned;
}

}  // namespace lumi
