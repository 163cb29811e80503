#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "calib/capture/image.h"

namespace lumi {

/// Interleaved samples of a picture: grey (1 or 2 channels) or RGB (3 or 4).
struct SampleLayout {
    int width_px = 0;
    int height_px = 0;
    int channels = 3;
    int alpha_channel = -1;        ///< -1: none.
    bool is_premultiplied = true;  ///< Whether colours are stored times their alpha.
};

/// The picture as seen before black; what is wholly transparent is black whatever its colours.
/// `hidden_share`: that part of the pixels.
template <class Pixel, class Sample>
[[nodiscard]] Image<Pixel> before_black(std::span<const Sample> samples, const SampleLayout& layout,
                                        double& hidden_share) {
    constexpr std::uint64_t kOpaque = std::numeric_limits<Sample>::max();
    const auto stride = static_cast<std::size_t>(layout.channels);
    const std::size_t green = layout.channels >= 3 ? 1 : 0;
    Image<Pixel> image(layout.width_px, layout.height_px);
    std::size_t hidden = 0;
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const Sample* sample = &samples[i * stride];
        Pixel& pixel = image.pixels()[i];
        pixel = {sample[0], sample[green], sample[2 * green]};
        if (layout.alpha_channel < 0) continue;
        const std::uint64_t alpha = sample[layout.alpha_channel];
        if (alpha == 0) ++hidden;
        if (alpha != 0 && layout.is_premultiplied) continue;
        const auto shown = [alpha](Sample color) {
            return static_cast<Sample>((color * alpha + kOpaque / 2) / kOpaque);
        };
        pixel = {shown(pixel.r), shown(pixel.g), shown(pixel.b)};
    }
    hidden_share = static_cast<double>(hidden) /
                   static_cast<double>(std::max<std::size_t>(1, image.pixels().size()));
    return image;
}

}  // namespace lumi
