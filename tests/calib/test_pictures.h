#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "calib/capture/image.h"

namespace lumi {

/// Smooth coloured waves and hard-edged tiles, shifted to the right by `shift_px`: every shift
/// gives another picture of the same scene.
[[nodiscard]] inline ColorImage wavy_picture(int width, int height, double shift_px = 0.0) {
    ColorImage picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double u = x - shift_px;
            const auto wave = [&](double fx, double fy) {
                return static_cast<std::uint8_t>(128 + 100 * std::sin(fx * u + fy * y));
            };
            const bool light = (static_cast<int>(std::floor(u / 23)) + y / 19) % 2 == 0;
            picture(x, y) = {wave(0.11, 0.03), wave(0.02, 0.13),
                             light ? wave(0.05, 0.07) : std::uint8_t{40}};
        }
    }
    return picture;
}

/// The same picture as a sensor with Gaussian noise of `sigma` levels sees it once more.
[[nodiscard]] inline ColorImage with_noise(ColorImage picture, double sigma, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, sigma);
    const auto noisy = [&](std::uint8_t value) {
        return static_cast<std::uint8_t>(std::clamp(std::lround(value + noise(random)), 0L, 255L));
    };
    for (Rgb8& pixel : picture.pixels()) pixel = {noisy(pixel.r), noisy(pixel.g), noisy(pixel.b)};
    return picture;
}

}  // namespace lumi
