#include "calib/matching/inlier_shares.h"

#include <utility>

namespace lumi {

std::vector<double> inlier_shares_of(const std::vector<PairMatches>& matches,
                                     const std::vector<VerifiedPair>& verified) {
    constexpr std::size_t kEnoughMatches = 40;
    std::vector<double> shares;
    auto pair = verified.begin();
    for (const PairMatches& candidate : matches) {
        while (pair != verified.end() && std::pair(pair->first, pair->second) <
                                             std::pair(candidate.first, candidate.second)) {
            ++pair;
        }
        if (candidate.matches.size() < kEnoughMatches) continue;
        const bool is_verified = pair != verified.end() && pair->first == candidate.first &&
                                 pair->second == candidate.second;
        const double inliers = is_verified ? static_cast<double>(pair->inliers.size()) : 0.0;
        shares.push_back(inliers / static_cast<double>(candidate.matches.size()));
    }
    return shares;
}

}  // namespace lumi
