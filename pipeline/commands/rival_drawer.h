#pragma once

#include <CLI/App.hpp>
#include <string>

#include "calib/work/progress.h"
#include "pipeline/commands/drawing_request.h"
#include "pipeline/commands/frame_drawer.h"

namespace lumi {

/// --rival, which excludes what methods of others have no use for; to be called after all other
/// options of drawing were added.
void add_rival_option(CLI::App& command, std::string& rival);

/// How a rival of this name draws (rival_named): pictures that were resampled in the mode that the
/// command line says, or else `adaptive`. Throws Error (E-RENDER-RIVAL: there is no such rival, or
/// it knows no modes; E-RENDER-MODE).
[[nodiscard]] RenderOptions rival_options_of(const std::string& rival,
                                             const DrawingRequest& request);

/// What it is called in names of files: "forward-warping", "two-plane-adaptive".
[[nodiscard]] std::string rival_method(const std::string& rival, const RenderOptions& options);

/// Draws the frames of one package as evaluate_rivals does (rival_evaluation.h). `lumigraph`
/// outlives it. Throws Error (E-RENDER-RIVAL: it cannot be drawn from this package, and why;
/// E-GL-...).
[[nodiscard]] FrameDrawer rival_drawer(const Lumigraph& lumigraph, const std::string& rival,
                                       const RenderOptions& options, Progress& progress);

}  // namespace lumi
