#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "render/lumigraph/depth_mesh.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {

/// Where the triangles of each kind begin in a depth mesh (DepthMesh::kind_begin).
using DepthKindBegins = std::array<std::size_t, kDepthKinds + 1>;

/// Triangles of one kind of a view's depth mesh, to be drawn into a strip of a depth layer.
struct DepthLayerDraw {
    int layer = 0;
    int strip_begin_px = 0;
    int strip_end_px = 0;
    int view_index = 0;
    int kind = 0;
    std::size_t first_index = 0;
    std::size_t index_count = 0;
};

/// All that is drawn for the sets, each view in the strips of those that have it (strip_ends), in
/// the order of layers. `kind_begins` is of all views.
[[nodiscard]] std::vector<DepthLayerDraw> depth_layer_draws(
    const std::vector<DepthViewSet>& sets, int layers, int width_px,
    const std::vector<DepthKindBegins>& kind_begins);

}  // namespace lumi
