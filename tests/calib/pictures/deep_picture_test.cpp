#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/calib/pictures/color_pictures.h"

namespace lumi {
namespace {

TEST(DeepPicture, FloatsAreLightAndEncodedByTheCurveOfSrgb) {
    const ScratchFolder scratch;
    constexpr int kWidth = 1001;
    cv::Mat ramp(1, kWidth, CV_32FC3);
    cv::Mat grey_ramp(1, kWidth, CV_32FC1);
    for (int x = 0; x < kWidth; ++x) {
        const float light = static_cast<float>(x) / (kWidth - 1);
        ramp.at<cv::Vec3f>(0, x) = {light, light * light, 1 - light};
        grey_ramp.at<float>(0, x) = light * light * light;
    }
    write_tiff(scratch / "ramp.tif", ramp);
    write_tiff(scratch / "grey.tif", grey_ramp);
    const SrgbPicture read = read_srgb_picture(scratch / "ramp.tif");
    const SrgbPicture grey = read_srgb_picture(scratch / "grey.tif");
    EXPECT_EQ(read.conversion.from, "linear light");
    EXPECT_EQ(read.conversion.clipped_share, 0);
    for (int x = 0; x < kWidth; ++x) {
        const double light = static_cast<double>(x) / (kWidth - 1);
        EXPECT_NEAR(read.picture(x, 0).r, 255 * srgb_of_light(light), 0.6) << x;
        EXPECT_NEAR(read.picture(x, 0).g, 255 * srgb_of_light(light * light), 0.6) << x;
        EXPECT_NEAR(read.picture(x, 0).b, 255 * srgb_of_light(1 - light), 0.6) << x;
        EXPECT_NEAR(grey.picture(x, 0).b, 255 * srgb_of_light(light * light * light), 0.6) << x;
    }
}

TEST(DeepPicture, WhatIsBrighterThanWhiteIsCutOffAndCounted) {
    const ScratchFolder scratch;
    constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
    constexpr float kEndless = std::numeric_limits<float>::infinity();
    cv::Mat samples(1, 8, CV_32FC3, cv::Scalar::all(0.25));
    samples.at<cv::Vec3f>(0, 0) = {4.0F, 0.25F, 0.25F};
    samples.at<cv::Vec3f>(0, 1) = {0.25F, kEndless, -kEndless};
    samples.at<cv::Vec3f>(0, 2) = {0.25F, 0.25F, kNoNumber};
    samples.at<cv::Vec3f>(0, 3) = {1.0F, 0.0F, -0.5F};
    write_tiff(scratch / "bright.tif", samples);
    const SrgbPicture read = read_srgb_picture(scratch / "bright.tif");
    const auto quarter = static_cast<std::uint8_t>(std::lround(255 * srgb_of_light(0.25)));
    EXPECT_DOUBLE_EQ(read.conversion.clipped_share, 3.0 / 8);
    EXPECT_EQ(read.picture(0, 0), (Rgb8{255, quarter, quarter}));
    EXPECT_EQ(read.picture(1, 0), (Rgb8{quarter, 255, 0}));
    EXPECT_EQ(read.picture(2, 0), (Rgb8{quarter, quarter, 0}));
    EXPECT_EQ(read.picture(3, 0), (Rgb8{255, 0, 0}));
}

TEST(DeepPicture, FloatsWithAProfileAreWhatItSays) {
    const ScratchFolder scratch;
    cv::Mat samples;
    matrix_of_colors(colors()).convertTo(samples, CV_32F, 1 / 255.0);
    write_tiff(scratch / "p3.tif", samples, display_p3_profile());
    write_tiff(scratch / "srgb.tif", samples, bytes_of_profile(cmsCreate_sRGBProfile()));
    const SrgbPicture p3 = read_srgb_picture(scratch / "p3.tif");
    EXPECT_EQ(p3.conversion.from, "Display P3");
    expect_converted(colors(), p3.picture, kDisplayP3Primaries, light_of_srgb);
    EXPECT_EQ(read_color_image(scratch / "srgb.tif"), colors());
}

TEST(DeepPicture, SixteenBitsAreRoundedToTheNearestLevel) {
    const ScratchFolder scratch;
    cv::Mat every_value(256, 256, CV_16UC1);
    for (int i = 0; i < 65536; ++i) {
        every_value.at<std::uint16_t>(i / 256, i % 256) = static_cast<std::uint16_t>(i);
    }
    cv::Mat colour;
    cv::merge(std::vector<cv::Mat>{every_value, every_value, every_value}, colour);
    const auto put_png = [&](const std::string& name, const cv::Mat& samples) {
        Bytes bytes;
        cv::imencode(".png", samples, bytes);
        scratch.put(name, bytes);
    };
    put_png("grey.png", every_value);
    put_png("colour.png", colour);
    write_tiff(scratch / "grey.tif", every_value);
    write_tiff(scratch / "colour.tif", colour);
    for (const std::string name : {"grey.png", "colour.png", "grey.tif", "colour.tif"}) {
        const SrgbPicture read = read_srgb_picture(scratch / name);
        EXPECT_EQ(read.conversion.from, "") << name;
        double largest = 0;
        for (int i = 0; i < 65536; ++i) {
            for (const std::uint8_t level :
                 {read.picture(i % 256, i / 256).r, read.picture(i % 256, i / 256).b}) {
                largest = std::max(largest, std::abs(level - i / 257.0));
            }
        }
        EXPECT_LE(largest, 0.5) << name;
    }
}

TEST(DeepPicture, SixteenBitsOfAProfileAreConvertedBeforeTheyAreRounded) {
    const ScratchFolder scratch;
    cv::Mat shadows(1, 512, CV_16UC3);
    for (int x = 0; x < 512; ++x) {
        const auto value = static_cast<std::uint16_t>(x);
        shadows.at<cv::Vec3w>(0, x) = {value, value, value};
    }
    write_tiff(scratch / "linear.tif", shadows,
               rgb_profile_of("linear", kSrgbPrimaries, cmsBuildGamma(nullptr, 1.0)));
    Bytes png;
    cv::imencode(".png", shadows, png);
    scratch.put("linear.png", png_with_chunk(png, "gAMA", {0, 1, 0x86, 0xa0}));
    EXPECT_EQ(read_srgb_picture(scratch / "linear.png").conversion.from, "linear light");
    for (const std::string name : {"linear.tif", "linear.png"}) {
        const ColorImage picture = read_color_image(scratch / name);
        for (int x = 0; x < 512; ++x) {
            EXPECT_NEAR(picture(x, 0).g, 255 * srgb_of_light(x / 65535.0), 0.6) << name << x;
        }
    }
    cv::Mat bright;
    matrix_of_colors(colors()).convertTo(bright, CV_16U, 257);
    write_tiff(scratch / "adobe.tif", bright,
               rgb_profile_of("Adobe RGB", kAdobePrimaries, cmsBuildGamma(nullptr, 563.0 / 256)));
    expect_converted(colors(), read_color_image(scratch / "adobe.tif"), kAdobePrimaries,
                     adobe_curve);
}

TEST(DeepPicture, OnlyALinearGammaOfAPngIsFollowed) {
    const ScratchFolder scratch;
    write_png(scratch / "plain.png", colors());
    const Bytes png = read_whole_file(scratch / "plain.png");
    scratch.put("usual.png", png_with_chunk(png, "gAMA", {0, 0, 0xb1, 0x8f}));
    EXPECT_EQ(read_color_image(scratch / "usual.png"), colors());
    const Bytes linear = png_with_chunk(png, "gAMA", {0, 1, 0x86, 0xa0});
    scratch.put("linear.png", linear);
    expect_converted(colors(), read_color_image(scratch / "linear.png"), kSrgbPrimaries,
                     [](double value) { return value; });
    scratch.put("said to be srgb.png", png_with_chunk(linear, "sRGB", {0}));
    EXPECT_EQ(read_color_image(scratch / "said to be srgb.png"), colors());
}

}  // namespace
}  // namespace lumi
