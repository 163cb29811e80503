#include "render/depth_layers/depth_layer_views.h"

#include <algorithm>
#include <cstddef>

namespace lumi {
namespace {

/// The layer in which an earlier set has the view; none: the number of layers.
std::size_t known_layer(const DepthLayerViews& earlier, int view, std::size_t layers) {
    for (const std::vector<int>& set : earlier) {
        const auto found = std::find(set.begin(), set.end(), view);
        if (found != set.end()) return static_cast<std::size_t>(found - set.begin());
    }
    return layers;
}

}  // namespace

DepthLayerViews depth_layer_views(const std::vector<DepthViewSet>& sets, int layers) {
    const auto layer_count = static_cast<std::size_t>(layers);
    DepthLayerViews all;
    for (const DepthViewSet& set : sets) {
        std::vector<int> in_layers(layer_count, kNoView);
        std::vector<int> left;
        for (const int view : set.view_indices) {
            const std::size_t layer = known_layer(all, view, layer_count);
            if (layer < layer_count && in_layers[layer] == kNoView) {
                in_layers[layer] = view;
            } else {
                left.push_back(view);
            }
        }
        for (const int view : left) *std::find(in_layers.begin(), in_layers.end(), kNoView) = view;
        all.push_back(std::move(in_layers));
    }
    return all;
}

}  // namespace lumi
