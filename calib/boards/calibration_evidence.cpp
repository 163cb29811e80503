#include "calib/boards/calibration_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "calib/boards/board_pose.h"
#include "calib/lens/lens_faults.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

void add_views(const BoardViews& board, const BoardSolution& solution,
               const std::vector<HeldOutFold>& held_out, BoardCalibration& result) {
    double sum = 0;
    double held_out_sum = 0;
    std::size_t points = 0;
    for (std::size_t index = 0; index < board.views.size(); ++index) {
        const BoardView& view = board.views[index];
        const std::vector<Eigen::Vector2d> predicted =
            predicted_px(view, solution.lens, solution.size_per_pitch,
                         solution.cam_from_board[index], solution.bow);
        double view_sum = 0;
        for (std::size_t point = 0; point < predicted.size(); ++point) {
            const Eigen::Vector2d error_px = predicted[point] - view.points[point].px;
            result.residuals.push_back({index, view.points[point].px, error_px});
            view_sum += error_px.squaredNorm();
        }
        const double count = static_cast<double>(view.points.size());
        std::optional<double> view_held_out_px;
        if (!held_out.empty()) {
            view_held_out_px = std::sqrt(held_out[index].squared_error_px2 / count);
            held_out_sum += held_out[index].squared_error_px2;
        }
        result.views.push_back(
            {view.photograph, view.points.size(), std::sqrt(view_sum / count), view_held_out_px,
             board_tilt_deg(view, solution.size_per_pitch, solution.cam_from_board[index])});
        sum += view_sum;
        points += view.points.size();
    }
    result.rms_px = std::sqrt(sum / static_cast<double>(points));
    if (!held_out.empty()) {
        result.held_out_rms_px = std::sqrt(held_out_sum / static_cast<double>(points));
    }
}

void add_coverage(const BoardViews& board, BoardCalibration& result) {
    constexpr std::size_t kParts = 10;
    std::array<bool, kParts * kParts> is_covered{};
    const Eigen::Vector2d size_px(board.width_px, board.height_px);
    for (const BoardResidual& residual : result.residuals) {
        const Eigen::Vector2d share = residual.px.cwiseQuotient(size_px);
        const auto part = [](double value) {
            return static_cast<std::size_t>(
                std::clamp(value * static_cast<double>(kParts), 0.0, kParts - 1.0));
        };
        is_covered[part(share.y()) * kParts + part(share.x())] = true;
        result.covered_radius = std::max(result.covered_radius,
                                         (residual.px - size_px / 2).norm() / (size_px / 2).norm());
    }
    result.covered_area =
        static_cast<double>(std::count(is_covered.begin(), is_covered.end(), true)) /
        static_cast<double>(is_covered.size());
}

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

void add_warnings(BoardCalibration& result) {
    constexpr std::size_t kFewViews = 8;
    constexpr double kSmallArea = 0.4;
    constexpr double kSmallRadius = 0.7;
    constexpr double kSmallTilt_deg = 15;
    constexpr double kStrongDisagreement = 4;
    if (result.views.size() < kFewViews) {
        result.warnings.push_back("only " + std::to_string(result.views.size()) +
                                  " photographs: ten to twenty make the lens more certain");
    }
    if (result.covered_area < kSmallArea) {
        result.warnings.push_back("the board was seen in " + percent(result.covered_area) +
                                  " of the picture: move it to the other parts as well");
    }
    if (result.covered_radius < kSmallRadius) {
        result.warnings.push_back("no point lies beyond " + percent(result.covered_radius) +
                                  " of the half diagonal: distortion in the corners is a guess");
    }
    std::vector<double> tilts_deg;
    for (const CalibratedView& view : result.views) tilts_deg.push_back(view.tilt_deg);
    if (median_of(tilts_deg) < kSmallTilt_deg) {
        result.warnings.push_back("the board mostly faces the camera (median tilt " +
                                  std::to_string(std::lround(median_of(tilts_deg))) +
                                  " degrees): tilt it by 20 to 50 degrees");
    }
    if (result.certainty.disagreement > kStrongDisagreement) {
        result.warnings.push_back(
            "photographs disagree about the lens " +
            std::to_string(std::lround(std::sqrt(result.certainty.disagreement))) +
            " times more than their points' errors explain: is the board flat, and the zoom and "
            "focus the same? The intervals contain what differs between photographs, not what all "
            "share, as a board that is bent otherwise than in a bow");
    }
}

}  // namespace

std::string fault_within(const BoardViews& board, const Camera& lens) {
    double farthest = 0;
    const Eigen::Vector2d centre_px = principal_point_px(lens);
    const Eigen::Vector2d focal_px = focal_length_px(lens);
    for (const BoardView& view : board.views) {
        for (const BoardPoint& point : view.points) {
            farthest = std::max(farthest, (point.px - centre_px).cwiseQuotient(focal_px).norm());
        }
    }
    return lens_fault(lens, farthest);
}

void add_evidence(const BoardViews& board, const BoardSolution& solution,
                  const std::vector<HeldOutFold>& held_out, BoardCalibration& result) {
    add_views(board, solution, held_out, result);
    add_coverage(board, result);
    add_warnings(result);
}

}  // namespace lumi
