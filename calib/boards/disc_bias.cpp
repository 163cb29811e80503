#include "calib/boards/disc_bias.h"

#include <cmath>
#include <numbers>

#include "calib/boards/board_pose.h"

namespace lumi {
namespace {

constexpr int kOutlinePoints = 24;

/// Centroid of the area within a polygon.
Eigen::Vector2d centroid_of(const std::vector<Eigen::Vector2d>& polygon) {
    // About the first corner, so that large coordinates do not eat the digits.
    const Eigen::Vector2d origin = polygon.front();
    double doubled_area = 0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t index = 0; index < polygon.size(); ++index) {
        const Eigen::Vector2d a = polygon[index] - origin;
        const Eigen::Vector2d b = polygon[(index + 1) % polygon.size()] - origin;
        const double cross = a.x() * b.y() - a.y() * b.x();
        doubled_area += cross;
        sum += cross * (a + b);
    }
    return origin + sum / (3 * doubled_area);
}

/// The outline of the disc around `centre`, as points of a board that counts as `view` does.
BoardView outline_of(const BoardView& view, const Eigen::Vector2d& centre, double radius) {
    BoardView outline;
    outline.middle = view.middle;
    outline.turn_rad = view.turn_rad;
    for (int index = 0; index < kOutlinePoints; ++index) {
        const double angle = 2 * std::numbers::pi * index / kOutlinePoints;
        BoardPoint point;
        point.place = centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        outline.points.push_back(point);
    }
    BoardPoint middle;
    middle.place = centre;
    outline.points.push_back(middle);
    return outline;
}

}  // namespace

BoardViews without_disc_bias(const BoardViews& seen, const BoardSolution& solution) {
    BoardViews corrected = seen;
    for (std::size_t index = 0; index < seen.views.size(); ++index) {
        const BoardView& view = seen.views[index];
        for (BoardPoint& point : corrected.views[index].points) {
            std::vector<Eigen::Vector2d> predicted =
                predicted_px(outline_of(view, point.place, 0.5 * seen.size_per_pitch),
                             solution.lens, 0.0, solution.cam_from_board[index], solution.bow);
            const Eigen::Vector2d centre_px = predicted.back();
            predicted.pop_back();
            const Eigen::Vector2d bias_px = centroid_of(predicted) - centre_px;
            if (bias_px.allFinite()) point.px -= bias_px;
        }
    }
    return corrected;
}

void correct_discs(BoardViews& board, BoardSolution& solution) {
    const BoardViews seen = board;
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) {
        board = without_disc_bias(seen, solution);
        solution = fit_lens(board, solution).solution;
    }
}

}  // namespace lumi
