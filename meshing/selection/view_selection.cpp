#include "meshing/selection/view_selection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace lumi {
namespace {

constexpr int kMaxMedoidRounds = 10;

/// Distances between all cameras, row by row.
class Distances {
 public:
    Distances(const std::vector<OpticalAxis>& axes, const Eigen::Vector3d& centre)
        : count_(axes.size()), values_(count_ * count_) {
        for (std::size_t a = 0; a < count_; ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                values_[a * count_ + b] = values_[b * count_ + a] =
                    viewpoint_distance(axes[a], axes[b], centre);
            }
        }
    }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] double operator()(std::size_t a, std::size_t b) const {
        return values_[a * count_ + b];
    }

 private:
    std::size_t count_;
    std::vector<double> values_;
};

/// The member of a group with the least sum of squared distances to the others.
std::size_t medoid_of(const std::vector<std::size_t>& group, const Distances& distance) {
    std::size_t best = group.front();
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t candidate : group) {
        double sum = 0;
        for (const std::size_t other : group) sum += std::pow(distance(candidate, other), 2);
        if (sum >= least) continue;
        least = sum;
        best = candidate;
    }
    return best;
}

std::vector<std::size_t> farthest_first(const Distances& distance, std::size_t count) {
    std::vector<std::size_t> everyone(distance.count());
    std::iota(everyone.begin(), everyone.end(), std::size_t{0});
    std::vector<std::size_t> chosen{medoid_of(everyone, distance)};
    std::vector<double> to_nearest(distance.count(), std::numeric_limits<double>::infinity());
    while (chosen.size() < count) {
        std::size_t farthest = 0;
        for (std::size_t i = 0; i < distance.count(); ++i) {
            to_nearest[i] = std::min(to_nearest[i], distance(i, chosen.back()));
            if (to_nearest[i] > to_nearest[farthest]) farthest = i;
        }
        if (!(to_nearest[farthest] > 0)) break;  // the rest are duplicates
        chosen.push_back(farthest);
    }
    for (std::size_t i = 0; chosen.size() < count; ++i) {
        if (std::find(chosen.begin(), chosen.end(), i) == chosen.end()) chosen.push_back(i);
    }
    return chosen;
}

/// Moves each chosen camera to the middle of its group; false when none moved.
bool move_to_medoids(std::vector<std::size_t>& chosen, const Distances& distance) {
    std::vector<std::vector<std::size_t>> groups(chosen.size());
    for (std::size_t i = 0; i < distance.count(); ++i) {
        std::size_t nearest = 0;
        for (std::size_t c = 1; c < chosen.size(); ++c) {
            if (distance(i, chosen[c]) < distance(i, chosen[nearest])) nearest = c;
        }
        groups[nearest].push_back(i);
    }
    bool moved = false;
    for (std::size_t c = 0; c < chosen.size(); ++c) {
        if (groups[c].empty()) continue;
        const std::size_t medoid = medoid_of(groups[c], distance);
        moved = moved || medoid != chosen[c];
        chosen[c] = medoid;
    }
    return moved;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) /
           std::max(1.0, static_cast<double>(values.size()));
}

/// How a choice's losses differ from the best one's, place by place.
void compare(ViewChoice& choice, const ViewChoice& best) {
    std::vector<double> excesses;
    for (std::size_t i = 0; i < choice.losses.size(); ++i) {
        excesses.push_back(choice.losses[i] - best.losses[i]);
    }
    choice.mean_excess = mean_of(excesses);
    double squares = 0;
    for (const double excess : excesses) squares += std::pow(excess - choice.mean_excess, 2);
    const auto count = static_cast<double>(excesses.size());
    choice.standard_error = count > 1 ? std::sqrt(squares / (count - 1) / count) : 0.0;
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

std::vector<int> representative_views(const std::vector<OpticalAxis>& axes,
                                      const Eigen::Vector3d& centre, int count) {
    if (axes.empty() || count <= 0) return {};
    std::vector<int> views;
    if (count >= static_cast<int>(axes.size())) {
        views.resize(axes.size());
        std::iota(views.begin(), views.end(), 0);
        return views;
    }
    const Distances distance(axes, centre);
    std::vector<std::size_t> chosen = farthest_first(distance, static_cast<std::size_t>(count));
    for (int round = 0; round < kMaxMedoidRounds && move_to_medoids(chosen, distance); ++round) {
    }
    std::set<int> distinct(chosen.begin(), chosen.end());
    // Of cameras on one spot two groups may have come to the same.
    for (int view = 0; static_cast<int>(distinct.size()) < count; ++view) distinct.insert(view);
    return {distinct.begin(), distinct.end()};
}

std::vector<int> selection_sizes(int views, int least) {
    std::vector<int> sizes;
    for (int size = views; size >= std::min(views, least);
         size = std::min(size - 1, size * 3 / 4)) {
        sizes.push_back(size);
        if (size <= 1) break;
    }
    return sizes;
}

ViewSelection select_views(const std::vector<OpticalAxis>& axes, const Eigen::Vector3d& centre,
                           const std::vector<int>& sizes, const HeldOutLosses& losses_of) {
    ViewSelection selection;
    std::size_t best = 0;
    for (const int size : sizes) {
        ViewChoice choice;
        choice.views = representative_views(axes, centre, size);
        choice.losses = losses_of(choice.views);
        choice.mean_loss = mean_of(choice.losses);
        selection.curve.push_back(std::move(choice));
        if (selection.curve.back().mean_loss < selection.curve[best].mean_loss) {
            best = selection.curve.size() - 1;
        }
    }
    for (std::size_t i = 0; i < selection.curve.size(); ++i) {
        ViewChoice& choice = selection.curve[i];
        compare(choice, selection.curve[best]);
        const bool is_as_good = choice.mean_excess <= choice.standard_error;
        const bool is_fewer = choice.views.size() <= selection.curve[selection.chosen].views.size();
        if (i == 0 || (is_as_good && is_fewer)) selection.chosen = i;
    }
    return selection;
}

}  // namespace lumi
