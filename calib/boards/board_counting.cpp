#include "calib/boards/board_counting.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "calib/boards/lens_certainty.h"

namespace lumi {
namespace {

constexpr Eigen::Index kBowColumns = 3;

/// Direction in which points spread farthest; half a turn more is the same direction.
double longer_way_rad(const BoardView& view) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const BoardPoint& point : view.points) {
        mean += point.place / static_cast<double>(view.points.size());
    }
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const BoardPoint& point : view.points) {
        spread += (point.place - mean) * (point.place - mean).transpose();
    }
    return 0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1));
}

Eigen::Vector2d middle_of(const BoardView& view) {
    if (view.points.empty()) return Eigen::Vector2d::Zero();
    Eigen::Vector2d least = view.points.front().place;
    Eigen::Vector2d most = least;
    for (const BoardPoint& point : view.points) {
        least = least.cwiseMin(point.place);
        most = most.cwiseMax(point.place);
    }
    return 0.5 * (least + most);
}

/// Equations of a photograph whose bow was its own, for that of a board that it counts turned.
ReducedView turned(ReducedView view, double turn_rad) {
    const Eigen::Matrix3d turn = bow_turned_by(turn_rad);
    view.information.rightCols<kBowColumns>() *= turn;
    view.information.bottomRows<kBowColumns>().applyOnTheLeft(turn.transpose());
    view.gradient.tail<kBowColumns>().applyOnTheLeft(turn.transpose());
    return view;
}

/// By how many turns each photograph counts, and what is left unexplained then.
struct Turns {
    std::vector<int> of_view;
    double residual_sum_px2 = 0.0;
};

class TurnSearch {
 public:
    TurnSearch(std::vector<ReducedView> own, int turns_alike) : own_(std::move(own)) {
        // After half a turn a bow is what it was.
        for (int turn = 0; 2 * turn < turns_alike; ++turn) {
            std::vector<ReducedView>& views = by_turn_.emplace_back();
            for (const ReducedView& view : own_) {
                views.push_back(turned(view, 2 * std::numbers::pi * turn / turns_alike));
            }
        }
    }

    /// From `start`, and from what the photograph that speaks most for a bow says alone.
    [[nodiscard]] std::vector<int> best(const std::vector<int>& start) const {
        const auto step = step_to_minimum(with(start));
        if (!step) return start;
        const Turns jointly = improved(start, step->change);
        const Turns from_one = improved(start, strongest_bow(start));
        return from_one.residual_sum_px2 < jointly.residual_sum_px2 ? from_one.of_view
                                                                    : jointly.of_view;
    }

 private:
    [[nodiscard]] std::vector<ReducedView> with(const std::vector<int>& turns) const {
        std::vector<ReducedView> views;
        for (std::size_t view = 0; view < turns.size(); ++view) {
            views.push_back(by_turn_[static_cast<std::size_t>(turns[view])][view]);
        }
        return views;
    }

    [[nodiscard]] Eigen::VectorXd strongest_bow(const std::vector<int>& turns) const {
        Eigen::VectorXd best = Eigen::VectorXd::Zero(own_.front().gradient.size());
        double most_px2 = 0;
        for (const ReducedView& view : with(turns)) {
            const Eigen::Matrix3d information =
                view.information.bottomRightCorner<kBowColumns, kBowColumns>();
            const Eigen::Vector3d gradient = view.gradient.tail<kBowColumns>();
            const Eigen::Vector3d bow = -information.ldlt().solve(gradient);
            const double gained_px2 = -bow.dot(gradient);
            if (!bow.allFinite() || gained_px2 <= most_px2) continue;
            most_px2 = gained_px2;
            best.tail<kBowColumns>() = bow;
        }
        return best;
    }

    /// Turns and what all share in turn, until nothing changes.
    [[nodiscard]] Turns improved(std::vector<int> turns, Eigen::VectorXd shared) const {
        constexpr int kMaxRounds = 8;
        Turns result{turns, 0.0};
        for (int round = 0; round < kMaxRounds; ++round) {
            const std::vector<int> before = turns;
            for (std::size_t view = 0; view < turns.size(); ++view) {
                turns[view] = better_turn(view, turns[view], shared);
            }
            const auto step = step_to_minimum(with(turns));
            if (!step) break;
            shared = step->change;
            result = {turns, 0.0};
            for (const ReducedView& view : step->views) {
                result.residual_sum_px2 += view.residual_sum_px2;
            }
            if (turns == before && round > 0) break;
        }
        return result;
    }

    [[nodiscard]] int better_turn(std::size_t view, int current,
                                  const Eigen::VectorXd& shared) const {
        const auto unexplained_px2 = [&](int turn) {
            return residual_sum_after_px2(by_turn_[static_cast<std::size_t>(turn)][view], shared);
        };
        int best = current;
        for (int turn = 0; turn < static_cast<int>(by_turn_.size()); ++turn) {
            if (unexplained_px2(turn) < unexplained_px2(best)) best = turn;
        }
        constexpr double kClearly = 3.0 * 3.0;
        const double variance_px2 = unexplained_px2(best) / own_[view].residuals;
        return unexplained_px2(current) - unexplained_px2(best) > kClearly * variance_px2 ? best
                                                                                          : current;
    }

    std::vector<ReducedView> own_;
    std::vector<std::vector<ReducedView>> by_turn_;
};

}  // namespace

void set_middles(BoardViews& board) {
    for (BoardView& view : board.views) view.middle = middle_of(view);
}

void count_alike(BoardViews& board, const BoardSolution& flat) {
    const auto whole = std::max_element(
        board.views.begin(), board.views.end(),
        [](const BoardView& a, const BoardView& b) { return a.points.size() < b.points.size(); });
    const double reference_rad = longer_way_rad(*whole);
    const double turn_rad = 2 * std::numbers::pi / board.turns_alike;
    const int half = board.turns_alike / 2;
    std::vector<int> turns;
    for (BoardView& view : board.views) {
        view.turn_rad = 0;
        const int turn =
            static_cast<int>(std::lround((longer_way_rad(view) - reference_rad) / turn_rad));
        turns.push_back(((turn % half) + half) % half);
    }
    BoardSolution bent = flat;
    bent.is_bent = true;
    const TurnSearch search(reduced_views(board, bent), board.turns_alike);
    turns = search.best(turns);
    for (std::size_t view = 0; view < board.views.size(); ++view) {
        board.views[view].turn_rad = turn_rad * turns[view];
    }
}

}  // namespace lumi
