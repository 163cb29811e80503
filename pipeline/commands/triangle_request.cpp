#include "pipeline/commands/triangle_request.h"

#include "calib/work/error.h"
#include "pipeline/commands/number_checks.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

constexpr const char* kMinTriangle = "--min-triangle";
constexpr const char* kMaxTriangle = "--max-triangle";
constexpr const char* kDepthThreshold = "--depth-threshold";

// Ever smaller ones would not be seen, and take memory without an end.
constexpr double kLeastMinTriangle_px = 0.5;
constexpr double kLeastMaxTriangle_px = 4.0;
constexpr double kMostTriangle_px = 100000.0;

void check_use(bool is_asked, bool has_use, const char* option, RenderMode mode,
               const std::string& users) {
    if (!is_asked || has_use) return;
    throw Error(ErrorKind::kUsage, "E-RENDER-TRIANGLE", name_of(mode) + " has no use for " + option,
                "leave it out, or use " + users);
}

std::string usual(double value, int decimals) {
    return " (default: " + number_text(value, decimals) + ")";
}

}  // namespace

std::vector<std::string> triangle_option_names() {
    return {kMinTriangle, kMaxTriangle, kDepthThreshold};
}

void add_triangle_options(CLI::App& command, TriangleRequest& request) {
    const RenderOptions options;
    command
        .add_option(kMinTriangle, request.min_triangle_px,
                    "paper2001: triangles whose longest edge is shorter are not split; adaptive: "
                    "no edges shorter than twice this, or longer where it may err by more; pixels" +
                        usual(options.min_triangle_px, 0))
        ->check(number_from_to(kLeastMinTriangle_px, kMostTriangle_px));
    command
        .add_option(kMaxTriangle, request.max_triangle_px,
                    "paper2001, adaptive: triangles with a longer edge are split in any case; "
                    "pixels" +
                        usual(options.max_triangle_px, 0))
        ->check(number_from_to(kLeastMaxTriangle_px, kMostTriangle_px));
    command
        .add_option(kDepthThreshold, request.depth_threshold_share,
                    "paper2001: a triangle is split while depths at its corners and its centre "
                    "differ by more than this share of the scene's depth range" +
                        usual(options.depth_threshold_share, 2))
        ->check(number_from_to(0.0, 1.0));
}

void apply(const TriangleRequest& request, RenderOptions& options) {
    const bool is_paper = options.mode == RenderMode::kPaper2001;
    const bool has_triangles = is_paper || options.mode == RenderMode::kAdaptive;
    const std::string both = "--mode paper2001 or --mode adaptive";
    check_use(request.min_triangle_px.has_value(), has_triangles, kMinTriangle, options.mode, both);
    check_use(request.max_triangle_px.has_value(), has_triangles, kMaxTriangle, options.mode, both);
    check_use(request.depth_threshold_share.has_value(), is_paper, kDepthThreshold, options.mode,
              "--mode paper2001");
    options.min_triangle_px = request.min_triangle_px.value_or(options.min_triangle_px);
    options.max_triangle_px = request.max_triangle_px.value_or(options.max_triangle_px);
    options.depth_threshold_share =
        request.depth_threshold_share.value_or(options.depth_threshold_share);
    if (options.min_triangle_px <= options.max_triangle_px) return;
    throw Error(ErrorKind::kUsage, "E-RENDER-TRIANGLE",
                "the smallest triangle, " + number_text(options.min_triangle_px, 1) +
                    " pixels, is larger than the largest, " +
                    number_text(options.max_triangle_px, 1),
                std::string("give both, ") + kMinTriangle + " and " + kMaxTriangle);
}

}  // namespace lumi
