#include "render/uploaded/photograph_opacity.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "calib/work/parallel_for.h"
#include "render/depth_mesh/depth_lattice.h"
#include "render/depth_search/occlusion.h"
#include "render/transfer/view_geometry.h"

namespace lumi {
namespace {

/// Of a pixel that holds two surfaces. Small against any other view's, but eight bits must hold it
/// where the border fades, too.
constexpr float kMixedShare = 1.0F / 8;
/// Of a pixel next to such a one. It is of one surface, but between the two their colours are
/// interpolated, and so is what they count: where that is kLeastCounting and more, a third of the
/// colour at most is the mixed pixel's.
constexpr float kBesideMixedShare = 0.3F;
/// Steps of 1/255 between the colours on both sides of an edge.
constexpr int kLeastContrast = 24;

/// Finds the pixels of a photograph that hold two surfaces.
class MixedPixels {
 public:
    MixedPixels(const LumigraphView& view, double disparity_px)
        : view_(view),
          lattice_(view.depth, view.camera, disparity_px),
          mixed_(view.depth.inverse_depth.width(), view.depth.inverse_depth.height()) {
        for (int y = 0; y < mixed_.height(); ++y) {
            for (int x = 0; x < mixed_.width(); ++x) {
                // The lattice has a ring of nodes around the samples.
                if (x + 1 < mixed_.width() && lattice_.tears_right(x + 1, y + 1)) mark(x, y, 1, 0);
                if (y + 1 < mixed_.height() && lattice_.tears_below(x + 1, y + 1)) mark(x, y, 0, 1);
            }
        }
    }

    [[nodiscard]] bool contain(int x_px, int y_px) const {
        return mixed_(x_px * mixed_.width() / view_.camera.width_px,
                      y_px * mixed_.height() / view_.camera.height_px) != 0;
    }

 private:
    /// The surface tears between a sample and the next. Only if the photograph shows it: where the
    /// depth map has the edge in a wrong place, pixels hold one surface.
    void mark(int x, int y, int step_x, int step_y) {
        const Rgb8& before = color_at(x - step_x, y - step_y);
        const Rgb8& beyond = color_at(x + 2 * step_x, y + 2 * step_y);
        const int contrast = std::max({std::abs(before.r - beyond.r), std::abs(before.g - beyond.g),
                                       std::abs(before.b - beyond.b)});
        if (contrast < kLeastContrast) return;
        mixed_(x, y) = 1;
        mixed_(x + step_x, y + step_y) = 1;
    }

    /// In the middle of a sample.
    [[nodiscard]] const Rgb8& color_at(int x, int y) const {
        const auto pixel = [](int sample, int samples, int pixels) {
            return (2 * std::clamp(sample, 0, samples - 1) + 1) * pixels / (2 * samples);
        };
        return view_.photograph(pixel(x, mixed_.width(), view_.camera.width_px),
                                pixel(y, mixed_.height(), view_.camera.height_px));
    }

    const LumigraphView& view_;
    DepthLattice lattice_;
    GrayImage mixed_;
};

/// What mixed pixels count, and the eight next to each, of what others do.
FloatImage shares_of_pixels(const LumigraphView& view, double disparity_px) {
    const int width = view.camera.width_px;
    const int height = view.camera.height_px;
    FloatImage shares(width, height, 1.0F);
    if (!view.has_depth()) return shares;
    const MixedPixels mixed(view, disparity_px);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (!mixed.contain(x, y)) continue;
            for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
                    shares(u, v) = std::min(shares(u, v), kBesideMixedShare);
            shares(x, y) = kMixedShare;
        }
    }
    return shares;
}

}  // namespace

GrayImage photograph_opacity(const LumigraphView& view, double disparity_px) {
    const int width = view.camera.width_px;
    const int height = view.camera.height_px;
    const FloatImage shares = shares_of_pixels(view, disparity_px);
    GrayImage opacity(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double to_border = std::min({x, y, width - 1 - x, height - 1 - y}) + 0.5;
            opacity(x, y) = static_cast<std::uint8_t>(
                std::lround(std::max(1.0, 255 * border_fade(to_border) * double{shares(x, y)})));
        }
    }
    return opacity;
}

std::vector<GrayImage> photograph_opacities(const Lumigraph& lumigraph) {
    const std::vector<ViewGeometry> geometries = view_geometries(lumigraph);
    std::vector<GrayImage> opacities(lumigraph.views.size());
    parallel_for(static_cast<int>(opacities.size()), 0, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        opacities[index] =
            photograph_opacity(lumigraph.views[index], max_disparity_px(geometries[index]));
    });
    return opacities;
}

}  // namespace lumi
