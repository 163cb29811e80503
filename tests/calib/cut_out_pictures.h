#pragma once

#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// Writes the picture as a PNG with an alpha channel: 0 in so many rows, 255 below.
inline void write_cut_out_png(const std::filesystem::path& path, const ColorImage& picture,
                              int hidden_rows) {
    std::vector<std::uint8_t> samples;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const Rgb8& pixel = picture(x, y);
            const std::uint8_t alpha = y < hidden_rows ? 0 : 255;
            samples.insert(samples.end(), {pixel.r, pixel.g, pixel.b, alpha});
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

}  // namespace lumi
