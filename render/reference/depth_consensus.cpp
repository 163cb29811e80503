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
    const auto is_near = [&](const EyeDepth& depth, double inverse_depth) {
        return std::abs(depth.inverse_depth - inverse_depth) <= agreeing_inverse_depth;
    };
    const auto layers_that = [&](const auto& fits) {
        std::vector<std::size_t> found;
        for (std::size_t layer = 0; layer < layers.size(); ++layer)
            if (is_seen(layers[layer]) && fits(layers[layer])) found.push_back(layer);
        return found;
    };
    const auto seen_at = [&](double inverse_depth) {
        return layers_that([&](const EyeDepth& depth) { return is_near(depth, inverse_depth); });
    };
    const auto seen_elsewhere_than = [&](double inverse_depth) {
        return layers_that([&](const EyeDepth& depth) { return !is_near(depth, inverse_depth); });
    };
    const auto take_away = [&](const std::vector<std::size_t>& taken) {
        for (const std::size_t layer : taken) layers[layer] = {};
    };
    double nearest = -1;
    double agreed = -1;
    for (const EyeDepth& depth : layers) {
        if (!is_seen(depth)) continue;
        nearest = std::max(nearest, depth.inverse_depth);
        if (seen_at(depth.inverse_depth).size() > 1) agreed = std::max(agreed, depth.inverse_depth);
    }
    if (nearest < 0 || seen_at(nearest).size() > 1) return;
    const auto is_any_past = [&](const std::vector<std::size_t>& asked, Past least,
                                 double nearest_seen) {
        return std::any_of(asked.begin(), asked.end(), [&](std::size_t layer) {
            return past(layer, nearest, nearest_seen) >= least;
        });
    };
    if (agreed >= 0) {
        const std::vector<std::size_t> behind = seen_at(agreed);
        const double nearest_seen = nearest_seen_past_for(agreed, agreeing_inverse_depth);
        if (!is_any_past(behind, Past::kPerhaps, nearest_seen)) take_away(behind);
    } else if (is_any_past(seen_elsewhere_than(nearest), Past::kSurely, kAnywhere)) {
        // What was imagined is gone: the next nearest is asked.
        take_away(seen_at(nearest));
        settle_lone_surface(layers, agreeing_inverse_depth, past);
    }
}

}  // namespace lumi
