#include "render/depth_layers/depth_layer_draws.h"

#include "render/depth_layers/depth_layer_views.h"

namespace lumi {
namespace {

void append_view(const DepthLayerDraw& where, const DepthKindBegins& begins,
                 std::vector<DepthLayerDraw>& draws) {
    for (int kind = 0; kind < kDepthKinds; ++kind) {
        const auto k = static_cast<std::size_t>(kind);
        if (begins[k + 1] == begins[k]) continue;
        DepthLayerDraw draw = where;
        draw.kind = kind;
        draw.first_index = begins[k];
        draw.index_count = begins[k + 1] - begins[k];
        draws.push_back(draw);
    }
}

}  // namespace

std::vector<DepthLayerDraw> depth_layer_draws(const std::vector<DepthViewSet>& sets, int layers,
                                              int width_px,
                                              const std::vector<DepthKindBegins>& kind_begins) {
    const std::vector<int> ends = strip_ends(sets, width_px);
    const DepthLayerViews views = depth_layer_views(sets, layers);
    std::vector<DepthLayerDraw> draws;
    for (int layer = 0; layer < layers; ++layer) {
        const auto view_in = [&](std::size_t set) {
            return views[set][static_cast<std::size_t>(layer)];
        };
        int begin = 0;
        for (std::size_t set = 0; set < ends.size(); ++set) {
            const int view = view_in(set);
            const bool goes_on = set + 1 < ends.size() && view_in(set + 1) == view;
            if (goes_on) continue;
            if (view != kNoView && begin < ends[set])
                append_view({layer, begin, ends[set], view},
                            kind_begins[static_cast<std::size_t>(view)], draws);
            begin = ends[set];
        }
    }
    return draws;
}

}  // namespace lumi
