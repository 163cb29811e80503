#include "meshing/selection/view_worth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "calib/work/median.h"
#include "meshing/selection/enclosing_views.h"
#include "meshing/selection/farthest_first.h"
#include "meshing/selection/thumbnail_prediction.h"

namespace lumi {
namespace {

constexpr std::size_t kMostByPhotographs = 1500;  // Time and memory grow with the square.
constexpr std::size_t kAround = 10;

/// Removes views one by one, each time the one that costs least.
class GreedyRemoval {
 public:
    GreedyRemoval(const std::vector<PicturedView>& views, const std::vector<OpticalAxis>& axes,
                  const Eigen::Vector3d& centre)
        : axes_(axes), centre_(centre), prediction_(views), is_kept_(axes.size(), 1) {
        for (const OpticalAxis& axis : axes) {
            directions_.push_back((axis.centre_in_world - centre).stableNormalized());
        }
        find_neighbours();
        for (std::size_t i = 0; i < axes.size(); ++i) {
            sources_.push_back(sources_without(static_cast<int>(i), -1));
            losses_db_.push_back(prediction_.loss_db(static_cast<int>(i), sources_.back()));
        }
        costs_db_.resize(axes.size());
        is_stale_.assign(axes.size(), 1);
    }

    /// The order in which they go; all but one.
    [[nodiscard]] std::vector<int> removed(const Progress& progress) {
        std::vector<int> order;
        while (order.size() + 1 < axes_.size()) {
            progress.throw_if_interrupted();
            order.push_back(cheapest());
            remove(order.back());
        }
        return order;
    }
    [[nodiscard]] bool is_kept(int view) const { return is_kept_[index(view)] != 0; }

 private:
    static std::size_t index(int view) { return static_cast<std::size_t>(view); }

    void find_neighbours() {
        std::vector<double> to_nearest;
        for (std::size_t i = 0; i < axes_.size(); ++i) {
            std::vector<std::pair<double, int>> others;
            for (std::size_t j = 0; j < axes_.size(); ++j) {
                if (i == j) continue;
                others.emplace_back(viewpoint_distance(axes_[i], axes_[j], centre_),
                                    static_cast<int>(j));
            }
            std::sort(others.begin(), others.end());
            neighbours_.emplace_back();
            for (const auto& [distance, view] : others) neighbours_.back().push_back(view);
            if (!others.empty()) to_nearest.push_back(others.front().first);
        }
        if (to_nearest.empty()) return;
        spacing_ = std::max(median_of(std::move(to_nearest)), std::numeric_limits<double>::min());
    }

    /// What a view is predicted from, itself and another one left out.
    [[nodiscard]] EnclosingViews sources_without(int view, int left_out) const {
        std::vector<int> around;
        for (const int other : neighbours_[index(view)]) {
            if (!is_kept(other) || other == left_out) continue;
            around.push_back(other);
            if (around.size() == kAround) break;
        }
        return enclosing_views(directions_[index(view)], directions_, around);
    }

    [[nodiscard]] bool draws_from(std::size_t view, int source) const {
        const std::vector<int>& views = sources_[view].views;
        return std::find(views.begin(), views.end(), source) != views.end();
    }

    [[nodiscard]] std::vector<int> users_of(int source) const {
        std::vector<int> users;
        for (std::size_t i = 0; i < sources_.size(); ++i) {
            if (draws_from(i, source)) users.push_back(static_cast<int>(i));
        }
        return users;
    }

    /// What the photographs lose by a removal.
    [[nodiscard]] double photographs_cost_db(int view) {
        double cost = 0;
        for (const int user : users_of(view)) {
            cost +=
                prediction_.loss_db(user, sources_without(user, view)) - losses_db_[index(user)];
        }
        return cost;
    }

    /// Distance to the nearest view but one, 0 where the view itself is left.
    [[nodiscard]] double gap_at(int view, int left_out) const {
        if (is_kept(view) && view != left_out) return 0.0;
        for (const int other : neighbours_[index(view)]) {
            if (is_kept(other) && other != left_out) {
                return viewpoint_distance(axes_[index(view)], axes_[index(other)], centre_);
            }
        }
        return std::numeric_limits<double>::max();
    }

    [[nodiscard]] double gap_loss_db(double distance) const {
        return std::pow(std::min(distance / spacing_, 1e6), 2);
    }

    /// What is lost where views stood, if each view were removed.
    [[nodiscard]] std::vector<double> gap_costs_db() const {
        std::vector<double> costs(axes_.size(), 0.0);
        for (std::size_t i = 0; i < axes_.size(); ++i) {
            const int view = static_cast<int>(i);
            int nearest = view;
            for (std::size_t k = 0; !is_kept(nearest); ++k) nearest = neighbours_[i][k];
            costs[index(nearest)] +=
                gap_loss_db(gap_at(view, nearest)) - gap_loss_db(gap_at(view, -1));
        }
        return costs;
    }

    [[nodiscard]] int cheapest() {
        const std::vector<double> gap_costs = gap_costs_db();
        int best = -1;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < axes_.size(); ++i) {
            const int view = static_cast<int>(i);
            if (!is_kept(view)) continue;
            if (is_stale_[i] != 0) costs_db_[i] = photographs_cost_db(view);
            is_stale_[i] = 0;
            const double cost = costs_db_[i] + gap_costs[i];
            if (best >= 0 && !(cost < least)) continue;
            least = cost;
            best = view;
        }
        return best;
    }

    void remove(int view) {
        const std::vector<int> users = users_of(view);
        is_kept_[index(view)] = 0;
        for (const int user : users) {
            make_stale(sources_[index(user)]);
            sources_[index(user)] = sources_without(user, -1);
            make_stale(sources_[index(user)]);
            losses_db_[index(user)] = prediction_.loss_db(user, sources_[index(user)]);
        }
        prediction_.forget(view);
    }

    void make_stale(const EnclosingViews& sources) {
        for (const int source : sources.views) is_stale_[index(source)] = 1;
    }

    const std::vector<OpticalAxis>& axes_;
    Eigen::Vector3d centre_;
    ThumbnailPrediction prediction_;
    std::vector<char> is_kept_;
    std::vector<Eigen::Vector3d> directions_;
    std::vector<std::vector<int>> neighbours_;  ///< Of each view all others, nearest first.
    double spacing_ = 1.0;
    std::vector<EnclosingViews> sources_;
    std::vector<double> losses_db_;
    std::vector<double> costs_db_;  ///< Of a removal, to the photographs.
    std::vector<char> is_stale_;
};

/// The view with the least sum of squared distances to all.
std::size_t middle_of(const std::vector<OpticalAxis>& axes, const Eigen::Vector3d& centre) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < axes.size(); ++i) {
        double sum = 0;
        for (const OpticalAxis& other : axes) {
            sum += std::pow(viewpoint_distance(axes[i], other, centre), 2);
        }
        if (sum >= least) continue;
        least = sum;
        best = i;
    }
    return best;
}

}  // namespace

double viewpoint_distance(const OpticalAxis& a, const OpticalAxis& b,
                          const Eigen::Vector3d& centre) {
    const Eigen::Vector3d to_a = a.centre_in_world - centre;
    const Eigen::Vector3d to_b = b.centre_in_world - centre;
    const double angle = std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b));
    const double least = 1e-12 * (to_a.norm() + to_b.norm()) + 1e-300;
    return angle +
           0.5 * std::abs(std::log(std::max(to_a.norm(), least) / std::max(to_b.norm(), least)));
}

std::vector<int> views_by_worth(const std::vector<PicturedView>& views,
                                const std::vector<OpticalAxis>& axes, const Eigen::Vector3d& centre,
                                const Progress& progress) {
    const bool has_depth = std::any_of(views.begin(), views.end(), [](const PicturedView& view) {
        return !view.depth->inverse_depth.empty();
    });
    if (!has_depth || views.size() > kMostByPhotographs) return views_far_apart(axes, centre);
    GreedyRemoval removal(views, axes, centre);
    std::vector<int> order = removal.removed(progress);
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (removal.is_kept(static_cast<int>(i))) order.push_back(static_cast<int>(i));
    }
    std::reverse(order.begin(), order.end());
    return order;
}

std::vector<int> views_far_apart(const std::vector<OpticalAxis>& axes,
                                 const Eigen::Vector3d& centre) {
    if (axes.empty()) return {};
    const auto count = static_cast<int>(axes.size());
    return farthest_first(count, static_cast<int>(middle_of(axes, centre)), count,
                          [&](int a, int b) {
                              return viewpoint_distance(axes[static_cast<std::size_t>(a)],
                                                        axes[static_cast<std::size_t>(b)], centre);
                          });
}

}  // namespace lumi
