#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/frame/frame.h"

namespace lumi {

/// How finely modes of triangles subdivide, as far as the command line says: the paper's parameters
/// (section 4).
struct TriangleRequest {
    std::optional<double> min_triangle_px;
    std::optional<double> max_triangle_px;
    std::optional<double> depth_threshold_share;
};

/// Their names as add_triangle_options adds them.
[[nodiscard]] std::vector<std::string> triangle_option_names();
void add_triangle_options(CLI::App& command, TriangleRequest& request);

/// Sets what the command line says. Throws Error (E-RENDER-TRIANGLE): the mode, which is that of
/// `options`, has no use for it, or the smallest triangle is larger than the largest.
void apply(const TriangleRequest& request, RenderOptions& options);

}  // namespace lumi
