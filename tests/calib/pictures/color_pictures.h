#pragma once

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <opencv2/core.hpp>
#include <string>

#include "calib/pictures/image_io.h"
#include "calib/pictures/srgb_curve.h"
#include "calib/work/whole_file.h"
#include "tests/calib/color_profiles.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {

/// Light of the primaries and D65 as XYZ: columns that sum to the white (CIE 15; SMPTE RP 177).
inline Eigen::Matrix3d xyz_of(const std::array<double, 6>& xy) {
    Eigen::Matrix3d primaries;
    for (int i = 0; i < 3; ++i) {
        const double x = xy[static_cast<std::size_t>(2 * i)];
        const double y = xy[static_cast<std::size_t>(2 * i + 1)];
        primaries.col(i) << x / y, 1.0, (1 - x - y) / y;
    }
    const Eigen::Vector3d white(0.3127 / 0.3290, 1.0, (1 - 0.3127 - 0.3290) / 0.3290);
    const Eigen::Vector3d amounts = primaries.inverse() * white;
    return primaries * amounts.asDiagonal();
}

using Curve = std::function<double(double)>;

inline double adobe_curve(double value) { return std::pow(value, 563.0 / 256.0); }

/// In levels, before they are rounded.
inline Eigen::Vector3d srgb_levels(const Eigen::Vector3d& encoded,
                                   const std::array<double, 6>& primaries, const Curve& light_of) {
    const Eigen::Vector3d light =
        xyz_of(kSrgbPrimaries).inverse() * xyz_of(primaries) *
        Eigen::Vector3d(light_of(encoded.x()), light_of(encoded.y()), light_of(encoded.z()));
    return {255 * srgb_of_light(light.x()), 255 * srgb_of_light(light.y()),
            255 * srgb_of_light(light.z())};
}

inline Eigen::Vector3d levels_of(const Rgb8& pixel) {
    return {1.0 * pixel.r, 1.0 * pixel.g, 1.0 * pixel.b};
}

/// Whether every pixel is what the closed form makes of what is stored, to a level.
inline void expect_converted(const ColorImage& stored, const ColorImage& converted,
                             const std::array<double, 6>& primaries, const Curve& light_of) {
    ASSERT_EQ(stored.pixels().size(), converted.pixels().size());
    double largest = 0;
    int moved = 0;
    for (std::size_t i = 0; i < stored.pixels().size(); ++i) {
        const Eigen::Vector3d before = levels_of(stored.pixels()[i]);
        const Eigen::Vector3d expected = srgb_levels(before / 255, primaries, light_of);
        const Eigen::Vector3d found = levels_of(converted.pixels()[i]);
        largest = std::max(largest, (found - expected).cwiseAbs().maxCoeff());
        moved += (found - before).cwiseAbs().maxCoeff() > 8 ? 1 : 0;
    }
    EXPECT_LE(largest, 1.0);
    EXPECT_GT(moved, 100) << "the picture has colours that the conversion changes";
}

/// Colours from all over the cube, the corners among them.
inline ColorImage colors() {
    ColorImage picture(18, 18);
    for (int y = 0; y < 18; ++y) {
        for (int x = 0; x < 18; ++x) {
            picture(x, y) = {static_cast<std::uint8_t>(51 * (x % 6)),
                             static_cast<std::uint8_t>(51 * (y % 6)),
                             static_cast<std::uint8_t>(
                                 51 * (x / 6 + 3 * (y / 6) == 8 ? 5 : (x / 6 + 3 * (y / 6)) % 6))};
        }
    }
    return picture;
}

inline Bytes jpeg_of(const ScratchFolder& scratch, const ColorImage& picture) {
    write_jpeg(scratch / "plain.jpg", picture, 98);
    return read_whole_file(scratch / "plain.jpg");
}

inline Bytes png_chunk(const std::string& type, const Bytes& content) {
    Bytes chunk;
    const auto append = [&](std::uint32_t number) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            chunk.push_back(static_cast<std::uint8_t>(number >> shift));
        }
    };
    append(static_cast<std::uint32_t>(content.size()));
    chunk.insert(chunk.end(), type.begin(), type.end());
    chunk.insert(chunk.end(), content.begin(), content.end());
    append(static_cast<std::uint32_t>(
        crc32(0, chunk.data() + 4, static_cast<unsigned>(chunk.size() - 4))));
    return chunk;
}

/// Behind the header.
inline Bytes png_with_chunk(Bytes png, const std::string& type, const Bytes& content) {
    constexpr std::ptrdiff_t kAfterHeader = 8 + 25;
    const Bytes chunk = png_chunk(type, content);
    png.insert(png.begin() + kAfterHeader, chunk.begin(), chunk.end());
    return png;
}

inline Bytes png_with_profile(const Bytes& png, const Bytes& profile) {
    Bytes compressed(compressBound(profile.size()));
    uLongf size = compressed.size();
    compress(compressed.data(), &size, profile.data(), profile.size());
    Bytes content{'i', 'c', 'c', 0, 0};
    content.insert(content.end(), compressed.begin(),
                   compressed.begin() + static_cast<std::ptrdiff_t>(size));
    return png_with_chunk(png, "iCCP", content);
}

template <class Describe>
void write_tiff(const std::filesystem::path& path, const cv::Mat& samples,
                const Describe& describe) {
    const OIIO::TypeDesc type = samples.depth() == CV_8U    ? OIIO::TypeDesc::UINT8
                                : samples.depth() == CV_16U ? OIIO::TypeDesc::UINT16
                                                            : OIIO::TypeDesc::FLOAT;
    OIIO::ImageSpec spec(samples.cols, samples.rows, samples.channels(), type);
    describe(spec);
    const auto output = OIIO::ImageOutput::create("tiff");
    ASSERT_TRUE(output->open(path.string(), spec)) << output->geterror();
    ASSERT_TRUE(output->write_image(type, samples.data)) << output->geterror();
    ASSERT_TRUE(output->close());
}

inline void write_tiff(const std::filesystem::path& path, const cv::Mat& samples,
                       const Bytes& profile = {}) {
    write_tiff(path, samples, [&](OIIO::ImageSpec& spec) {
        if (profile.empty()) return;
        spec.attribute("ICCProfile",
                       OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                       profile.data());
    });
}

/// Red first, as OpenImageIO writes it.
inline cv::Mat matrix_of_colors(const ColorImage& picture) {
    return cv::Mat(picture.height(), picture.width(), CV_8UC3, const_cast<Rgb8*>(picture.row(0)))
        .clone();
}

}  // namespace lumi
