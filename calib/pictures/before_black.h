#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

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
/// `shown`: 0 where it is, else 255; empty where nothing is.
template <class Pixel, class Sample>
[[nodiscard]] Image<Pixel> before_black(std::span<const Sample> samples, const SampleLayout& layout,
                                        GrayImage& shown) {
    constexpr std::uint64_t kOpaque = std::numeric_limits<Sample>::max();
    const auto stride = static_cast<std::size_t>(layout.channels);
    const std::size_t green = layout.channels >= 3 ? 1 : 0;
    Image<Pixel> image(layout.width_px, layout.height_px);
    GrayImage mask(layout.width_px, layout.height_px, 255);
    bool hides = false;
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const Sample* sample = &samples[i * stride];
        Pixel& pixel = image.pixels()[i];
        pixel = {sample[0], sample[green], sample[2 * green]};
        if (layout.alpha_channel < 0) continue;
        const std::uint64_t alpha = sample[layout.alpha_channel];
        if (alpha == 0) {
            mask.pixels()[i] = 0;
            hides = true;
        }
        if (alpha != 0 && layout.is_premultiplied) continue;
        const auto darkened = [alpha](Sample color) {
            return static_cast<Sample>((color * alpha + kOpaque / 2) / kOpaque);
        };
        pixel = {darkened(pixel.r), darkened(pixel.g), darkened(pixel.b)};
    }
    shown = hides ? std::move(mask) : GrayImage();
    return image;
}

}  // namespace lumi
