#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What a shader is told of the view that each layer of depth shows: four vectors for each of
/// kMaxDepthViews layers. `view_indices` are those of the layers, kNoView for none.
using LayerRows = std::vector<glm::vec4>;

/// Where a view sees points of the eye's rays, as shaders/agreed_depth.glsl asks: of window
/// coordinates in the eye's picture, pixels of the photographs.
[[nodiscard]] LayerRows pixel_rows(const Lumigraph& lumigraph, const Eye& eye,
                                   const std::vector<int>& view_indices);

/// The same as shaders/lone_surfaces.glsl asks: of texels of the layers' eye, samples of the depth
/// maps, and how many of these there are.
[[nodiscard]] LayerRows sample_rows(const Lumigraph& lumigraph, const Eye& depth_eye,
                                    const std::vector<int>& view_indices);

}  // namespace lumi
