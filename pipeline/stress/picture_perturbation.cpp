#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "calib/pictures/srgb_curve.h"
#include "pipeline/stress/perturbation.h"
#include "pipeline/stress/seeded_normal.h"

namespace lumi {
namespace {

constexpr int kDepthCells = 32;

/// Smooth noise: normal values on a lattice, interpolated between its points.
double lattice_noise(const SeededNormal& random, std::uint64_t view, double x, double y) {
    const double column = std::floor(x);
    const double row = std::floor(y);
    const auto at = [&](double u, double v) {
        return random.value(view,
                            static_cast<std::uint64_t>(v) * 4096U + static_cast<std::uint64_t>(u));
    };
    const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
    const double u = smooth(x - column);
    const double v = smooth(y - row);
    const double top = (1.0 - u) * at(column, row) + u * at(column + 1, row);
    const double bottom = (1.0 - u) * at(column, row + 1) + u * at(column + 1, row + 1);
    return (1.0 - v) * top + v * bottom;
}

/// Encoded values after the exposure is changed in linear light.
std::array<std::uint8_t, 256> exposed_values(double ev) {
    std::array<std::uint8_t, 256> values{};
    for (int i = 0; i < 256; ++i) {
        const double light = light_of_srgb(i / 255.0) * std::exp2(ev);
        values[static_cast<std::size_t>(i)] =
            static_cast<std::uint8_t>(std::lround(255.0 * srgb_of_light(light)));
    }
    return values;
}

}  // namespace

Lumigraph with_noisy_depth(const Lumigraph& lumigraph, double percent, std::uint64_t seed) {
    const SeededNormal random(seed);
    Lumigraph result = lumigraph;
    for (std::size_t i = 0; i < result.views.size(); ++i) {
        result.views[i].depth_mesh.reset();  // It follows the depth as it was.
        FloatImage& inverse_depth = result.views[i].depth.inverse_depth;
        const double cells_per_px = kDepthCells / std::max(1.0, double(inverse_depth.width()));
        for (int y = 0; y < inverse_depth.height(); ++y) {
            for (int x = 0; x < inverse_depth.width(); ++x) {
                const double noise =
                    lattice_noise(random, i, (x + 0.5) * cells_per_px, (y + 0.5) * cells_per_px);
                const double factor = std::max(0.0, 1.0 + percent / 100.0 * noise);
                inverse_depth(x, y) *= static_cast<float>(factor);
            }
        }
    }
    return result;
}

Lumigraph with_other_exposure(const Lumigraph& lumigraph, double sigma_ev, std::uint64_t seed) {
    const SeededNormal random(seed);
    Lumigraph result = lumigraph;
    for (std::size_t i = 0; i < result.views.size(); ++i) {
        const std::array<std::uint8_t, 256> values = exposed_values(sigma_ev * random.value(i, 0));
        for (Rgb8& pixel : result.views[i].photograph.pixels()) {
            pixel = {values[pixel.r], values[pixel.g], values[pixel.b]};
        }
    }
    return result;
}

Lumigraph with_blurred_photographs(const Lumigraph& lumigraph, double sigma_px,
                                   std::uint64_t /*seed*/) {
    static_assert(sizeof(Rgb8) == 3);
    Lumigraph result = lumigraph;
    for (LumigraphView& view : result.views) {
        ColorImage& photograph = view.photograph;
        cv::Mat pixels(photograph.height(), photograph.width(), CV_8UC3,
                       photograph.pixels().data());
        cv::GaussianBlur(pixels.clone(), pixels, cv::Size(), sigma_px, sigma_px,
                         cv::BORDER_REPLICATE);
    }
    return result;
}

}  // namespace lumi
