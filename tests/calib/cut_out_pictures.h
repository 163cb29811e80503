#pragma once

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// Writes the picture as a PNG with this alpha channel.
inline void write_cut_out_png(const std::filesystem::path& path, const ColorImage& picture,
                              const GrayImage& alpha) {
    std::vector<std::uint8_t> samples;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const Rgb8& pixel = picture(x, y);
            samples.insert(samples.end(), {pixel.r, pixel.g, pixel.b, alpha(x, y)});
        }
    }
    std::filesystem::create_directories(path.parent_path());
    OIIO::ImageSpec spec(picture.width(), picture.height(), 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto output = OIIO::ImageOutput::create("png");
    if (!output->open(path.string(), spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, samples.data()) || !output->close())
        throw std::runtime_error(path.string() + ": " + output->geterror());
}

/// The same with an alpha of 0 in so many rows, 255 below.
inline void write_cut_out_png(const std::filesystem::path& path, const ColorImage& picture,
                              int hidden_rows) {
    GrayImage alpha(picture.width(), picture.height(), 255);
    std::fill_n(alpha.pixels().begin(), hidden_rows * picture.width(), std::uint8_t{0});
    write_cut_out_png(path, picture, alpha);
}

}  // namespace lumi
