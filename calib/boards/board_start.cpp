#include "calib/boards/board_start.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "calib/boards/board_pose.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

/// Every n-th, so that at most `count` remain.
template <class Value>
std::vector<Value> sample_of(const std::vector<Value>& values, std::size_t count) {
    std::vector<Value> sample;
    const std::size_t step = std::max<std::size_t>(1, (values.size() + count - 1) / count);
    for (std::size_t index = 0; index < values.size(); index += step) {
        sample.push_back(values[index]);
    }
    return sample;
}

Camera lens_with(const BoardViews& board, LensModel model, double focal_px) {
    Camera lens{board.width_px, board.height_px, model,
                std::vector<double>(parameter_count(model), 0.0)};
    std::size_t index = 0;
    lens.parameters[index++] = focal_px;
    if (!has_one_focal_length(model)) lens.parameters[index++] = focal_px;
    lens.parameters[index++] = 0.5 * board.width_px;
    lens.parameters[index] = 0.5 * board.height_px;
    return lens;
}

double median_rms_px(const std::vector<BoardView>& views, const Camera& lens, double size) {
    std::vector<double> rms_px;
    for (const BoardView& view : views) {
        const auto solved = rough_board_pose(view, lens, size);
        rms_px.push_back(solved ? solved->rms_px : std::numeric_limits<double>::infinity());
    }
    return median_of(rms_px, std::numeric_limits<double>::infinity());
}

}  // namespace

std::optional<BoardStart> start_of_calibration(const BoardViews& board, LensModel model) {
    constexpr std::size_t kSampledViews = 7;
    constexpr std::size_t kSampledPoints = 40;
    std::vector<BoardView> views = sample_of(board.views, kSampledViews);
    for (BoardView& view : views) view.points = sample_of(view.points, kSampledPoints);

    const bool is_fisheye = model == LensModel::kOpenCvFisheye;
    const double longer_px = std::max(board.width_px, board.height_px);
    const double first_px = (is_fisheye ? 0.16 : 0.3) * longer_px;
    const double last_px = (is_fisheye ? 2.0 : 8.0) * longer_px;
    constexpr double kStep = 1.22;
    BoardStart start;
    start.median_rms_px = std::numeric_limits<double>::infinity();
    for (double focal_px = first_px; focal_px < last_px; focal_px *= kStep) {
        const Camera lens = lens_with(board, model, focal_px);
        const double rms_px = median_rms_px(views, lens, board.size_per_pitch);
        if (rms_px < start.median_rms_px) {
            start.median_rms_px = rms_px;
            start.lens = lens;
        }
    }
    if (!std::isfinite(start.median_rms_px)) return std::nullopt;
    std::size_t solved_views = 0;
    for (const BoardView& view : board.views) {
        const auto solved = solve_board_pose(view, start.lens, board.size_per_pitch);
        start.cam_from_board.push_back(solved ? std::optional(solved->cam_from_board)
                                              : std::nullopt);
        if (solved) ++solved_views;
    }
    if (2 * solved_views < board.views.size()) return std::nullopt;
    return start;
}

}  // namespace lumi
