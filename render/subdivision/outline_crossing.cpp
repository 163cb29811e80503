#include "render/subdivision/outline_crossing.h"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>

namespace lumi {
namespace {

/// Smears of less are hardly seen.
constexpr double kLeastJump_px = 8.0;
/// The outline lies anywhere in a stretch that is left so long.
constexpr double kFinest_px = 3.0;
/// Of a jump, that one half of the edge holds; a slope has as much in the other.
constexpr double kMost = 0.7;

Eigen::Vector2d middle_of(const BlendVertex& a, const BlendVertex& b) {
    return 0.5 * (vector_of(a.pixel) + vector_of(b.pixel));
}

/// How far apart photographs that count would be looked up at the depths of two vertices.
double jump_px(const DepthSearch& search, const BlendVertex& a, const BlendVertex& b) {
    const Eigen::Vector2d pixel = middle_of(a, b);
    double farthest_px = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (a.weights[k] <= 0 && b.weights[k] <= 0) continue;
        const EpipolarLine line = search.line_in(static_cast<int>(a.view_layers[k]), pixel);
        const auto at_a = line.at(static_cast<double>(a.inverse_depth));
        const auto at_b = line.at(static_cast<double>(b.inverse_depth));
        if (at_a && at_b) farthest_px = std::max(farthest_px, (at_a->pixel - at_b->pixel).norm());
    }
    return farthest_px;
}

/// The vertex at a pixel next to it, as far away as it is.
BlendVertex moved_to(const Eigen::Vector2d& pixel, const DepthSearch& search, BlendVertex vertex) {
    vertex.pixel = {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto in_view = search.line_in(static_cast<int>(vertex.view_layers[k]), pixel)
                                 .at(static_cast<double>(vertex.inverse_depth));
        if (!in_view) continue;
        vertex.view_pixels[k] = {static_cast<float>(in_view->pixel.x()),
                                 static_cast<float>(in_view->pixel.y())};
    }
    return vertex;
}

}  // namespace

std::optional<OutlineCrossing> outline_crossing(const PatchSampler& sampler,
                                                const BlendVertex& from, const BlendVertex& to) {
    const DepthSearch& search = sampler.search();
    const double whole_px = jump_px(search, from, to);
    if (whole_px < kLeastJump_px) return std::nullopt;
    OutlineCrossing crossing{from, to};
    double stretch_px = (vector_of(from.pixel) - vector_of(to.pixel)).norm();
    for (; stretch_px > kFinest_px; stretch_px *= 0.5) {
        const BlendVertex middle =
            blend_vertex(sampler.at(middle_of(crossing.at_from, crossing.at_to)), sampler.polygon(),
                         VertexDepth::kAffine);
        const double before_px = jump_px(search, crossing.at_from, middle);
        const double after_px = jump_px(search, middle, crossing.at_to);
        if (std::max(before_px, after_px) < kMost * whole_px) return std::nullopt;
        (before_px > after_px ? crossing.at_to : crossing.at_from) = middle;
    }
    const Eigen::Vector2d pixel = middle_of(crossing.at_from, crossing.at_to);
    return OutlineCrossing{moved_to(pixel, search, crossing.at_from),
                           moved_to(pixel, search, crossing.at_to)};
}

}  // namespace lumi
