#include "calib/mapping/feature_tracks.h"

#include <algorithm>
#include <numeric>

namespace lumi {
namespace {

/// Sets of features of which no two are of one photograph.
class TrackForest {
 public:
    explicit TrackForest(const std::vector<std::size_t>& feature_counts) {
        for (std::size_t photograph = 0; photograph < feature_counts.size(); ++photograph) {
            offsets_.push_back(elements_.size());
            for (std::size_t feature = 0; feature < feature_counts[photograph]; ++feature) {
                elements_.push_back(
                    {static_cast<int>(photograph), static_cast<std::uint32_t>(feature)});
            }
        }
        parents_.resize(elements_.size());
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
        members_.resize(elements_.size());
    }

    void join(const TrackElement& a, const TrackElement& b) {
        std::size_t into = root_of(node_of(a));
        std::size_t from = root_of(node_of(b));
        if (into == from) return;
        if (members_[into].size() < members_[from].size()) std::swap(into, from);
        FeatureTrack joined;
        const FeatureTrack of_into = track_of(into);
        const FeatureTrack of_from = track_of(from);
        std::merge(of_into.begin(), of_into.end(), of_from.begin(), of_from.end(),
                   std::back_inserter(joined), is_before);
        const auto same_photograph = [](const TrackElement& x, const TrackElement& y) {
            return x.photograph == y.photograph;
        };
        if (std::adjacent_find(joined.begin(), joined.end(), same_photograph) != joined.end()) {
            return;
        }
        parents_[from] = into;
        members_[into] = std::move(joined);
        members_[from] = {};
    }

    [[nodiscard]] std::vector<FeatureTrack> tracks() {
        std::vector<FeatureTrack> tracks;
        for (FeatureTrack& members : members_) {
            if (!members.empty()) tracks.push_back(std::move(members));
        }
        std::sort(tracks.begin(), tracks.end(),
                  [](const auto& a, const auto& b) { return is_before(a.front(), b.front()); });
        return tracks;
    }

 private:
    static bool is_before(const TrackElement& a, const TrackElement& b) {
        return a.photograph != b.photograph ? a.photograph < b.photograph : a.feature < b.feature;
    }
    [[nodiscard]] std::size_t node_of(const TrackElement& element) const {
        return offsets_[static_cast<std::size_t>(element.photograph)] + element.feature;
    }
    std::size_t root_of(std::size_t node) {
        while (parents_[node] != node) {
            parents_[node] = parents_[parents_[node]];
            node = parents_[node];
        }
        return node;
    }
    [[nodiscard]] FeatureTrack track_of(std::size_t root) const {
        return members_[root].empty() ? FeatureTrack{elements_[root]} : members_[root];
    }

    std::vector<std::size_t> offsets_;
    std::vector<TrackElement> elements_;
    std::vector<std::size_t> parents_;
    std::vector<FeatureTrack> members_;  ///< Of roots with more than one element.
};

}  // namespace

std::vector<FeatureTrack> join_tracks(const std::vector<std::size_t>& feature_counts,
                                      const std::vector<VerifiedPair>& pairs) {
    std::vector<const VerifiedPair*> strongest_first;
    for (const VerifiedPair& pair : pairs) strongest_first.push_back(&pair);
    std::stable_sort(
        strongest_first.begin(), strongest_first.end(),
        [](const auto* a, const auto* b) { return a->inliers.size() > b->inliers.size(); });
    TrackForest forest(feature_counts);
    for (const VerifiedPair* const pair : strongest_first) {
        for (const FeatureMatch& match : pair->inliers) {
            forest.join({pair->first, match.first}, {pair->second, match.second});
        }
    }
    return forest.tracks();
}

}  // namespace lumi
