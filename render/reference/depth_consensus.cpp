#include "render/reference/depth_consensus.h"

#include <algorithm>
#include <cmath>

namespace lumi {

ConsensusDepth consensus_of(const std::vector<EyeDepth>& layers, double agreeing_inverse_depth) {
    ConsensusDepth chosen;
    bool any = false;
    for (const EyeDepth& depth : layers) {
        if (!depth.is_known()) continue;
        chosen.kind = any ? std::min(chosen.kind, depth.kind) : depth.kind;
        any = true;
    }
    const auto agrees = [&](const EyeDepth& depth, double inverse_depth) {
        return depth.is_known() && depth.kind == chosen.kind &&
               std::abs(depth.inverse_depth - inverse_depth) <= agreeing_inverse_depth;
    };
    for (const EyeDepth& candidate : layers) {
        if (!candidate.is_known() || candidate.kind != chosen.kind) continue;
        const auto agreeing = std::count_if(
            layers.begin(), layers.end(),
            [&](const EyeDepth& other) { return agrees(other, candidate.inverse_depth); });
        const int support = std::min(2, static_cast<int>(agreeing));
        // What was seen hides what is behind it; a fill continues the background.
        const bool nearer = candidate.inverse_depth > chosen.inverse_depth;
        const bool better = chosen.support == 0 || nearer == (chosen.kind == DepthKind::kSeen);
        if (support > chosen.support || (support == chosen.support && better)) {
            chosen.support = support;
            chosen.inverse_depth = candidate.inverse_depth;
        }
    }
    double sum = 0;
    int count = 0;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        if (!agrees(layers[layer], chosen.inverse_depth)) continue;
        if (count == 0) chosen.best_layer = static_cast<int>(layer);
        chosen.is_behind_tears =
            layers[layer].is_behind_tear && (count == 0 || chosen.is_behind_tears);
        sum += layers[layer].inverse_depth;
        ++count;
    }
    if (count > 0) chosen.inverse_depth = sum / count;
    return chosen;
}

void settle_lone_surface(std::vector<EyeDepth>& layers, double agreeing_inverse_depth,
                         const PastOfLayer& past) {
    const auto is_seen = [](const EyeDepth& depth) {
        return depth.is_known() && depth.kind == DepthKind::kSeen;
    };
    // Those that have seen something there, or elsewhere.
    const auto seen = [&](bool there, double inverse_depth) {
        std::vector<std::size_t> found;
        for (std::size_t layer = 0; layer < layers.size(); ++layer) {
            const double difference = std::abs(layers[layer].inverse_depth - inverse_depth);
            if (is_seen(layers[layer]) && (difference <= agreeing_inverse_depth) == there)
                found.push_back(layer);
        }
        return found;
    };
    const auto take_away = [&](const std::vector<std::size_t>& taken) {
        for (const std::size_t layer : taken) layers[layer] = {};
    };
    double nearest = -1;
    double agreed = -1;
    for (const EyeDepth& depth : layers) {
        if (!is_seen(depth)) continue;
        nearest = std::max(nearest, depth.inverse_depth);
        if (seen(true, depth.inverse_depth).size() > 1)
            agreed = std::max(agreed, depth.inverse_depth);
    }
    if (nearest < 0 || seen(true, nearest).size() > 1) return;
    const auto is_any_past = [&](const std::vector<std::size_t>& asked, Past least,
                                 double nearest_seen) {
        return std::any_of(asked.begin(), asked.end(), [&](std::size_t layer) {
            return past(layer, nearest, nearest_seen) >= least;
        });
    };
    if (agreed >= 0) {
        const std::vector<std::size_t> behind = seen(true, agreed);
        const double nearest_seen = nearest_seen_past_for(agreed, agreeing_inverse_depth);
        if (!is_any_past(behind, Past::kPerhaps, nearest_seen)) take_away(behind);
    } else if (is_any_past(seen(false, nearest), Past::kSurely, kAnywhere)) {
        take_away(seen(true, nearest));
        settle_lone_surface(layers, agreeing_inverse_depth, past);
    }
}

}  // namespace lumi
