#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "pipeline/commands/eye_file.h"
#include "pipeline/commands/triangle_request.h"
#include "render/frame/frame.h"
#include "render/lumigraph/package.h"

namespace lumi {

/// How frames are to be drawn, as far as the command line says.
struct DrawingRequest {
    std::optional<std::string> mode;
    std::optional<std::string> debug;
    double focal_depth = 0.0;
    std::string focal_view;
    double aperture = 0.0;
    bool supersample = false;
    bool jagged = false;
    bool fade = false;
    bool no_fade = false;
    bool black_surroundings = false;
    bool as_taken = false;
    TriangleRequest triangles;
};

void add_drawing_options(CLI::App& command, DrawingRequest& request);

/// What the command line says, else what the eye's file says, else what is usual; whether the
/// capture fades is then left to the package. Throws Error (E-RENDER-MODE, E-RENDER-DEBUG;
/// E-RENDER-OPTION: the mode has no use for fading, or for jagged silhouettes; E-RENDER-TRIANGLE).
/// What is sharp is not among it (focus.h): that may take the package.
[[nodiscard]] RenderOptions render_options_of(const DrawingRequest& request,
                                              const DrawnAlike& eye_file);
/// Whether what lies beyond the capture fades to black; empty: as the package says.
[[nodiscard]] std::optional<bool> fade_of(const DrawingRequest& request,
                                          const DrawnAlike& eye_file);
[[nodiscard]] Exposures exposures_of(const DrawingRequest& request, const DrawnAlike& eye_file);

}  // namespace lumi
