#include "meshing/surface/gradual_choice.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace lumi {
namespace {

/// What costs more than another by this share is not chosen instead.
constexpr double kNearly = 0.04;
constexpr std::size_t kConsidered = 8;
constexpr std::size_t kMostChoices = 4;
/// Taken from each choice but the largest, so that there are few.
constexpr double kLeastShare = 0.02;

using Things = std::vector<std::size_t>;

/// Takes things one by one.
class Choosing {
 public:
    Choosing(const std::vector<double>& costs, std::size_t size) : costs_(costs), size_(size) {}

    [[nodiscard]] std::map<Things, double> among(const Things& things) {
        complete({}, things, 1.0);
        return std::move(shares_);
    }

 private:
    void complete(Things chosen, const Things& rest, double share) {
        if (chosen.size() == size_ || rest.empty()) {
            std::sort(chosen.begin(), chosen.end());
            shares_[chosen] += share;
            return;
        }
        const std::vector<double> shares = shares_of(rest);
        for (std::size_t i = 0; i < rest.size(); ++i) {
            if (!(shares[i] > 0)) continue;
            Things with = chosen;
            with.push_back(rest[i]);
            Things without = rest;
            without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
            complete(std::move(with), without, share * shares[i]);
        }
    }

    [[nodiscard]] std::vector<double> shares_of(const Things& rest) const {
        double least = costs_[rest.front()];
        for (const std::size_t thing : rest) least = std::min(least, costs_[thing]);
        std::vector<double> shares;
        for (const std::size_t thing : rest)
            shares.push_back(std::max(0.0, 1 - (costs_[thing] / least - 1) / kNearly));
        const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
        for (double& share : shares) share /= sum;
        return shares;
    }

    const std::vector<double>& costs_;
    std::size_t size_;
    std::map<Things, double> shares_;
};

Things cheapest(const std::vector<double>& costs) {
    Things things(costs.size());
    std::iota(things.begin(), things.end(), std::size_t{0});
    const std::size_t count = std::min(kConsidered, things.size());
    std::partial_sort(things.begin(), things.begin() + static_cast<std::ptrdiff_t>(count),
                      things.end(), [&](std::size_t a, std::size_t b) {
                          return costs[a] != costs[b] ? costs[a] < costs[b] : a < b;
                      });
    things.resize(count);
    return things;
}

/// What comes next to the largest choices that are kept, but no less than the least share.
double share_that_is_left_out(const std::map<Things, double>& choices) {
    std::vector<double> shares;
    for (const auto& [chosen, share] : choices) shares.push_back(share);
    std::sort(shares.rbegin(), shares.rend());
    const double next = shares.size() > kMostChoices ? shares[kMostChoices] : 0.0;
    return std::max(next, kLeastShare);
}

}  // namespace

std::vector<GradualChoice> gradual_choices(const std::vector<double>& costs, std::size_t size) {
    const std::map<Things, double> all = Choosing(costs, size).among(cheapest(costs));
    const double left_out = share_that_is_left_out(all);
    std::vector<GradualChoice> choices;
    double sum = 0;
    for (const auto& [chosen, share] : all) {
        if (!(share > left_out)) continue;
        choices.push_back({chosen, share - left_out});
        sum += share - left_out;
    }
    // As many as can be, all alike.
    if (choices.empty()) return {{all.begin()->first, 1.0}};
    for (GradualChoice& choice : choices) choice.share /= sum;
    return choices;
}

}  // namespace lumi
