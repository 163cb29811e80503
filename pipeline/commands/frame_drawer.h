#pragma once

#include <string>

#include "pipeline/commands/drawing_request.h"
#include "pipeline/commands/stereo_pair.h"

namespace lumi {

/// Draws the frames of one package, and what drew them: "reference", "synthetic aperture", or the
/// OpenGL by its own words.
struct FrameDrawer {
    Draw draw;
    std::string renderer;
};

/// By OpenGL; with `by_reference` by the plain-code renderer; with an aperture as
/// dynamically_reparameterized.h does. `lumigraph` outlives it. Throws Error (E-VIEW-NAME: no
/// photograph has the name of the focal view; what the renderers throw).
[[nodiscard]] FrameDrawer frame_drawer(const Lumigraph& lumigraph, RenderOptions options,
                                       const DrawingRequest& request, bool by_reference);

}  // namespace lumi
