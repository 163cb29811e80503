#include "meshing/surface/gradual_choice.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace lumi {
namespace {

/// What costs more than another by this share is not chosen instead.
constexpr double kNearlyShare = 0.04;
/// Of which three can be chosen in 56 ways.
constexpr std::size_t kMostConsidered = 8;
/// Taken from each choice, so that there are few; the largest has more than that.
constexpr double kLeastShare = 0.01;

using Candidates = std::vector<std::size_t>;

/// Takes candidates one by one.
class Selection {
 public:
    Selection(const std::vector<double>& costs, std::size_t size) : costs_(costs), size_(size) {}

    [[nodiscard]] std::map<Candidates, double> among(const Candidates& candidates) {
        complete({}, candidates, 1.0);
        return std::move(shares_);
    }

 private:
    void complete(Candidates chosen, const Candidates& rest, double share) {
        if (chosen.size() == size_ || rest.empty()) {
            std::sort(chosen.begin(), chosen.end());
            shares_[chosen] += share;
            return;
        }
        const std::vector<double> shares = shares_of(rest);
        for (std::size_t i = 0; i < rest.size(); ++i) {
            if (!(shares[i] > 0)) continue;
            Candidates with = chosen;
            with.push_back(rest[i]);
            Candidates without = rest;
            without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
            complete(std::move(with), without, share * shares[i]);
        }
    }

    [[nodiscard]] std::vector<double> shares_of(const Candidates& rest) const {
        double least = costs_[rest.front()];
        for (const std::size_t candidate : rest) least = std::min(least, costs_[candidate]);
        std::vector<double> shares;
        for (const std::size_t candidate : rest)
            shares.push_back(std::max(0.0, 1 - (costs_[candidate] / least - 1) / kNearlyShare));
        const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
        for (double& share : shares) share /= sum;
        return shares;
    }

    const std::vector<double>& costs_;
    std::size_t size_;
    std::map<Candidates, double> shares_;
};

Candidates cheapest(const std::vector<double>& costs) {
    Candidates candidates(costs.size());
    std::iota(candidates.begin(), candidates.end(), std::size_t{0});
    const std::size_t count = std::min(kMostConsidered, candidates.size());
    std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count),
                      candidates.end(), [&](std::size_t a, std::size_t b) {
                          return costs[a] != costs[b] ? costs[a] < costs[b] : a < b;
                      });
    candidates.resize(count);
    return candidates;
}

}  // namespace

std::vector<GradualChoice> gradual_choices(const std::vector<double>& costs, std::size_t size) {
    const std::map<Candidates, double> all = Selection(costs, size).among(cheapest(costs));
    std::vector<GradualChoice> choices;
    double sum = 0;
    for (const auto& [chosen, share] : all) {
        if (!(share > kLeastShare)) continue;
        choices.push_back({chosen, share - kLeastShare});
        sum += share - kLeastShare;
    }
    for (GradualChoice& choice : choices) choice.share /= sum;
    return choices;
}

}  // namespace lumi
