#include "calib/boards/board_copies.h"

#include <algorithm>
#include <limits>

#include "calib/work/median.h"

namespace lumi {
namespace {

double distance_to_nearest_px(const Eigen::Vector2d& px, const BoardView& view) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const BoardPoint& point : view.points) {
        nearest = std::min(nearest, (point.px - px).squaredNorm());
    }
    return std::sqrt(nearest);
}

bool show_the_same(const BoardView& a, const BoardView& b) {
    const auto [fewer, more] = std::minmax(a.points.size(), b.points.size());
    // From one file to the next saved from it, few points are found in one alone.
    if (10 * fewer < 9 * more) return false;
    constexpr std::size_t kSample = 20;
    constexpr double kSame_px = 0.25;
    std::vector<double> distances_px;
    const std::size_t step = std::max<std::size_t>(1, a.points.size() / kSample);
    for (std::size_t index = 0; index < a.points.size(); index += step) {
        distances_px.push_back(distance_to_nearest_px(a.points[index].px, b));
    }
    return median_of(std::move(distances_px), std::numeric_limits<double>::infinity()) < kSame_px;
}

}  // namespace

std::vector<LeftOut> remove_copies(BoardViews& board) {
    std::vector<LeftOut> copies;
    std::vector<BoardView> kept;
    for (BoardView& view : board.views) {
        const auto original = std::find_if(kept.begin(), kept.end(), [&](const BoardView& other) {
            return show_the_same(view, other);
        });
        if (original == kept.end()) {
            kept.push_back(std::move(view));
        } else {
            copies.push_back({view.photograph, "E-BOARD-COPY",
                              "it shows the board exactly where " + original->photograph +
                                  " does, and tells nothing new"});
        }
    }
    board.views = std::move(kept);
    return copies;
}

}  // namespace lumi
