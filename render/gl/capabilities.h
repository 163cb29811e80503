#pragma once

#include <string>

namespace lumi {

/// What the current OpenGL context can do, as far as lumi asks.
struct Capabilities {
    bool is_es = false;
    int version = 0;  ///< 33 for 3.3.
    int max_texture_size_px = 0;
    int max_renderbuffer_size_px = 0;
    int max_array_layers = 0;
    bool works_on_cpu = false;  ///< As Mesa's software renderers do.
    std::string description;    ///< GL_RENDERER and GL_VERSION.
};

/// Throws Error (E-GL-CONTEXT) when the current context is older than OpenGL 3.3 or ES 3.0.
[[nodiscard]] Capabilities query_capabilities();

}  // namespace lumi
