#include "render/view_choice/depth_view_choice.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "calib/work/parallel_for.h"
#include "render/faces/strip_ends.h"
#include "render/view_choice/view_sight.h"

namespace lumi {
namespace {

/// A view that is worth less by no more than this share might be the best of an eye close by.
constexpr double kNearlyAsMuch = 0.03;
constexpr double kOnlyTheBest = 1e-12;
/// So much of the picture is taken from each set that is not the best: most of them get nothing.
constexpr double kLeastShare = 0.02;

std::vector<Eigen::Vector2d> grid_over(const Camera& camera) {
    std::vector<Eigen::Vector2d> pixels;
    for (int row = 0; row <= kSightSteps; ++row)
        for (int column = 0; column <= kSightSteps; ++column)
            pixels.emplace_back(column * camera.width_px / static_cast<double>(kSightSteps),
                                row * camera.height_px / static_cast<double>(kSightSteps));
    return pixels;
}

/// Those with depth; all where none has any.
std::vector<int> candidates_of(const Lumigraph& lumigraph) {
    const bool has_depth = lumigraph.has_depth();
    std::vector<int> candidates;
    for (std::size_t view = 0; view < lumigraph.views.size(); ++view)
        if (!has_depth || lumigraph.views[view].has_depth())
            candidates.push_back(static_cast<int>(view));
    return candidates;
}

/// Takes views one by one; until it is made they go by their numbers among the candidates.
class Choice {
 public:
    Choice(const Lumigraph& lumigraph, const Eye& eye, int max_views, double nearly)
        : max_views_(max_views), nearly_(nearly), candidates_(candidates_of(lumigraph)) {
        const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
        const SightSamples samples = sight_samples(lumigraph, eye, grid_over(eye.camera));
        sights_.resize(candidates_.size());
        parallel_for(static_cast<int>(sights_.size()), 0, [&](int i) {
            const auto candidate = static_cast<std::size_t>(i);
            const auto view = static_cast<std::size_t>(candidates_[candidate]);
            sights_[candidate] = sight_of(lumigraph.views[view], eye_in_world, samples.points);
        });
        worth_ = samples.worth;
    }

    [[nodiscard]] std::vector<DepthViewSet> sets() {
        complete({{}, 1.0}, worth_);
        for (DepthViewSet& set : sets_)
            for (int& view : set.view_indices) view = candidates_[static_cast<std::size_t>(view)];
        return std::move(sets_);
    }

 private:
    /// What each view would add; nothing once it is taken.
    [[nodiscard]] std::vector<double> gains(const std::vector<int>& chosen,
                                            const Eigen::RowVectorXd& worth) const {
        std::vector<double> all;
        for (const ViewSight& sight : sights_) all.push_back(sight.closeness.dot(worth));
        for (const int view : chosen) all[static_cast<std::size_t>(view)] = 0.0;
        return all;
    }

    void complete(const DepthViewSet& set, const Eigen::RowVectorXd& worth) {
        if (static_cast<int>(set.view_indices.size()) == max_views_) return add(set);
        const std::vector<double> gain = gains(set.view_indices, worth);
        const auto best = std::max_element(gain.begin(), gain.end());
        if (*best <= 0) {
            // The first view may see nothing.
            return set.view_indices.empty() ? add({{static_cast<int>(best - gain.begin())}, 1.0})
                                            : add(set);
        }
        const std::vector<double> shares = shares_of(gain, *best);
        for (std::size_t view = 0; view < shares.size(); ++view) {
            const double share = shares[view] * set.share;
            const bool is_best = static_cast<std::ptrdiff_t>(view) == best - gain.begin();
            if (is_best || share > kLeastShare)
                complete_with(static_cast<int>(view), is_best ? share : share - kLeastShare, set,
                              worth);
        }
    }

    /// The less the more a view is worse than the best; nothing where it is clearly worse.
    [[nodiscard]] std::vector<double> shares_of(const std::vector<double>& gain,
                                                double best) const {
        std::vector<double> shares;
        for (const double of_view : gain)
            shares.push_back(std::max(0.0, 1 - (1 - of_view / best) / nearly_));
        const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
        for (double& share : shares) share /= sum;
        return shares;
    }

    void complete_with(int view, double share, DepthViewSet set, const Eigen::RowVectorXd& worth) {
        set.view_indices.push_back(view);
        set.share = share;
        const Eigen::RowVectorXd& inside = sights_[static_cast<std::size_t>(view)].inside;
        complete(set, worth.array() * (1 - (1 - kWorthOfNext) * inside.array()));
    }

    void add(const DepthViewSet& set) {
        for (DepthViewSet& known : sets_) {
            if (known.view_indices != set.view_indices) continue;
            known.share += set.share;
            return;
        }
        sets_.push_back(set);
    }

    int max_views_;
    double nearly_;
    std::vector<int> candidates_;  ///< Indices of views.
    std::vector<ViewSight> sights_;
    Eigen::RowVectorXd worth_;
    std::vector<DepthViewSet> sets_;
};

/// The first kMaxDepthViewSets, less what the next one has: so that none is gone all at once.
void keep_largest(std::vector<DepthViewSet>& sets) {
    const std::size_t most = kMaxDepthViewSets;
    const double next = sets.size() > most ? sets[most].share : 0.0;
    if (next >= sets.front().share) sets.resize(1);
    while (sets.size() > most || (sets.size() > 1 && sets.back().share <= next)) sets.pop_back();
    double sum = 0;
    for (const DepthViewSet& set : sets) sum += set.share - next;
    for (DepthViewSet& set : sets) set.share = sum > 0 ? (set.share - next) / sum : 1.0;
}

}  // namespace

std::vector<int> choose_depth_views(const Lumigraph& lumigraph, const Eye& eye, int max_views) {
    return Choice(lumigraph, eye, max_views, kOnlyTheBest).sets().front().view_indices;
}

std::array<int, 3> three_with_repeats(const std::vector<int>& view_indices) {
    assert(!view_indices.empty() && view_indices.size() <= 3);
    return {view_indices.front(), view_indices[std::min<std::size_t>(1, view_indices.size() - 1)],
            view_indices.back()};
}

std::vector<DepthViewSet> depth_view_sets(const Lumigraph& lumigraph, const Eye& eye,
                                          int max_views) {
    std::vector<DepthViewSet> sets = Choice(lumigraph, eye, max_views, kNearlyAsMuch).sets();
    std::sort(sets.begin(), sets.end(),
              [](const DepthViewSet& a, const DepthViewSet& b) { return a.share > b.share; });
    keep_largest(sets);
    std::sort(sets.begin(), sets.end(), [](const DepthViewSet& a, const DepthViewSet& b) {
        return a.view_indices < b.view_indices;
    });
    return sets;
}

double agreeing_inverse_depth(const Lumigraph& lumigraph,
                              const std::vector<ViewGeometry>& geometries,
                              const std::vector<DepthViewSet>& sets,
                              const Eigen::Vector3d& eye_in_world, double tolerance_px) {
    double mean = 0;
    for (const DepthViewSet& set : sets)
        mean += set.share * agreeing_inverse_depth(lumigraph, geometries, set.view_indices,
                                                   eye_in_world, tolerance_px);
    return mean;
}

std::vector<int> strip_ends(const std::vector<DepthViewSet>& sets, int width_px) {
    std::vector<double> shares;
    for (const DepthViewSet& set : sets) shares.push_back(set.share);
    return strip_ends(shares, width_px);
}

}  // namespace lumi
