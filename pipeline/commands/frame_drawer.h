#pragma once

#include <string>

#include "pipeline/commands/stereo_pair.h"

namespace lumi {

/// Draws the frames of one package, and what drew them: "reference", "synthetic aperture", or the
/// OpenGL by its own words.
struct FrameDrawer {
    Draw draw;
    std::string renderer;
};

/// By OpenGL; with `by_reference` by the plain-code renderer; with an aperture, its diameter in
/// world units, as dynamically_reparameterized.h does. `lumigraph` outlives it. Throws Error (what
/// the renderers throw).
[[nodiscard]] FrameDrawer frame_drawer(const Lumigraph& lumigraph, const RenderOptions& options,
                                       double aperture, bool by_reference);

}  // namespace lumi
