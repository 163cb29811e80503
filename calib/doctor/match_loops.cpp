#include "calib/doctor/match_loops.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

namespace lumi {
namespace {

/// Two features of one place: orientations of one spot, or neighbouring scales.
constexpr float kSamePlace_px = 4.0F;
constexpr std::size_t kMostThirds = 6;

/// Matches from one photograph to another, by the feature in the first.
using Way = std::unordered_map<std::uint32_t, std::uint32_t>;

/// The ways from every photograph to its neighbours.
class Ways {
 public:
    Ways(std::size_t photographs, const std::vector<const VerifiedPair*>& pairs)
        : neighbours_(photographs) {
        for (const VerifiedPair* pair : pairs) {
            Way there;
            Way back;
            for (const FeatureMatch& match : pair->inliers) {
                there.emplace(match.first, match.second);
                back.emplace(match.second, match.first);
            }
            neighbours_[static_cast<std::size_t>(pair->first)].emplace(pair->second,
                                                                       std::move(there));
            neighbours_[static_cast<std::size_t>(pair->second)].emplace(pair->first,
                                                                        std::move(back));
        }
    }

    [[nodiscard]] const Way& between(int from, int to) const {
        return neighbours_[static_cast<std::size_t>(from)].at(to);
    }

    /// Photographs that both share most with.
    [[nodiscard]] std::vector<int> thirds(int first, int second) const {
        std::vector<std::pair<std::size_t, int>> shared;
        const auto& of_second = neighbours_[static_cast<std::size_t>(second)];
        for (const auto& [third, way] : neighbours_[static_cast<std::size_t>(first)]) {
            const auto other = of_second.find(third);
            if (other == of_second.end()) continue;
            shared.emplace_back(std::min(way.size(), other->second.size()), third);
        }
        std::sort(shared.begin(), shared.end(), [](const auto& a, const auto& b) {
            return a.first != b.first ? a.first > b.first : a.second < b.second;
        });
        shared.resize(std::min(shared.size(), kMostThirds));
        std::vector<int> thirds;
        for (const auto& entry : shared) thirds.push_back(entry.second);
        return thirds;
    }

 private:
    std::vector<std::map<int, Way>> neighbours_;
};

}  // namespace

MatchLoops follow_matches(const std::vector<ColmapPhotograph>& photographs,
                          const std::vector<const VerifiedPair*>& pairs) {
    MatchLoops loops;
    const Ways ways(photographs.size(), pairs);
    for (const VerifiedPair* pair : pairs) {
        const auto& pixels = photographs[static_cast<std::size_t>(pair->second)].keypoints_px;
        for (const int third : ways.thirds(pair->first, pair->second)) {
            const Way& to_third = ways.between(pair->first, third);
            const Way& from_third = ways.between(third, pair->second);
            for (const FeatureMatch& match : pair->inliers) {
                const auto middle = to_third.find(match.first);
                if (middle == to_third.end()) continue;
                const auto end = from_third.find(middle->second);
                if (end == from_third.end()) continue;
                const float distance_px = (pixels[end->second] - pixels[match.second]).norm();
                ++(distance_px <= kSamePlace_px ? loops.closed : loops.conflicts);
            }
        }
    }
    return loops;
}

}  // namespace lumi
