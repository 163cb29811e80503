#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "calib/work/error.h"
#include "tests/calib/pictures/color_pictures.h"

namespace lumi {
namespace {

TEST(AlphaAndInks, WhatAlphaHidesIsBlackAndCounted) {
    const ScratchFolder scratch;
    // Opaque, 40 % and hidden, twice each but for the last, which is there four times.
    const std::vector<std::uint8_t> alphas{255, 255, 102, 102, 0, 0, 0, 0};
    cv::Mat samples(1, 8, CV_8UC4);
    cv::Mat for_opencv(1, 8, CV_8UC4);
    cv::Mat premultiplied(1, 8, CV_8UC4);
    cv::Mat greys(1, 8, CV_8UC2);
    for (int x = 0; x < 8; ++x) {
        const std::uint8_t alpha = alphas[static_cast<std::size_t>(x)];
        samples.at<cv::Vec4b>(0, x) = {200, 100, 50, alpha};
        for_opencv.at<cv::Vec4b>(0, x) = {50, 100, 200, alpha};
        greys.at<cv::Vec2b>(0, x) = {100, alpha};
        premultiplied.at<cv::Vec4b>(0, x) =
            alpha == 102 ? cv::Vec4b(80, 40, 20, alpha) : cv::Vec4b(200, 100, 50, alpha);
    }
    Bytes png;
    cv::imencode(".png", for_opencv, png);
    scratch.put("straight.png", png);
    const auto straight = [](OIIO::ImageSpec& spec) {
        spec.attribute("oiio:UnassociatedAlpha", 1);
        spec.alpha_channel = spec.nchannels - 1;
    };
    write_tiff(scratch / "straight.tif", samples, straight);
    write_tiff(scratch / "grey.tif", greys, straight);
    write_tiff(scratch / "premultiplied.tif", premultiplied);
    cv::Mat deep;
    samples.convertTo(deep, CV_16U, 257);
    write_tiff(scratch / "deep.tif", deep, straight);
    for (const std::string name :
         {"straight.png", "straight.tif", "grey.tif", "premultiplied.tif", "deep.tif"}) {
        const SrgbPicture read = read_srgb_picture(scratch / name);
        const bool is_grey = name == "grey.tif";
        EXPECT_DOUBLE_EQ(read.conversion.hidden_share, 0.5) << name;
        EXPECT_EQ(read.picture(1, 0), is_grey ? (Rgb8{100, 100, 100}) : (Rgb8{200, 100, 50}))
            << name;
        EXPECT_EQ(read.picture(3, 0), is_grey ? (Rgb8{40, 40, 40}) : (Rgb8{80, 40, 20})) << name;
        for (int x = 4; x < 8; ++x) EXPECT_EQ(read.picture(x, 0), Rgb8{}) << name;
    }
    write_png(scratch / "opaque.png", colors());
    EXPECT_EQ(read_srgb_picture(scratch / "opaque.png").conversion.hidden_share, 0);
}

/// Inverted inks as Adobe stores them.
Bytes cmyk_jpeg(const cv::Mat& inks) {
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    void* encoder = tjInitCompress();
    tjCompress2(encoder, inks.data, inks.cols, 0, inks.rows, TJPF_CMYK, &buffer, &size, TJSAMP_444,
                100, TJFLAG_ACCURATEDCT);
    const Bytes bytes(buffer, buffer + size);
    tjFree(buffer);
    tjDestroy(encoder);
    return bytes;
}

/// Lightness of a neutral, 0 to 1, by inks, 0 to 1: linear in each, so that a grid of corners has
/// it.
double lightness_of_inks(double c, double m, double y, double k) {
    return (1 - k) * (1 - 0.5 * c) * (1 - 0.25 * m) * (1 - 0.125 * y);
}

Bytes ink_profile() {
    cmsHPROFILE profile = cmsCreateProfilePlaceholder(nullptr);
    cmsSetProfileVersion(profile, 2.1);
    cmsSetDeviceClass(profile, cmsSigInputClass);
    cmsSetColorSpace(profile, cmsSigCmykData);
    cmsSetPCS(profile, cmsSigLabData);
    name_profile(profile, "Some inks");
    cmsPipeline* pipeline = cmsPipelineAlloc(nullptr, 4, 3);
    cmsStage* grid = cmsStageAllocCLut16bit(nullptr, 2, 4, 3, nullptr);
    cmsStageSampleCLut16bit(
        grid,
        [](const cmsUInt16Number in[], cmsUInt16Number out[], void*) -> cmsInt32Number {
            out[0] = static_cast<cmsUInt16Number>(
                std::lround(0xff00 * lightness_of_inks(in[0] / 65535.0, in[1] / 65535.0,
                                                       in[2] / 65535.0, in[3] / 65535.0)));
            out[1] = out[2] = 0x8000;
            return 1;
        },
        nullptr, 0);
    cmsPipelineInsertStage(pipeline, cmsAT_END, grid);
    cmsWriteTag(profile, cmsSigAToB0Tag, pipeline);
    cmsPipelineFree(pipeline);
    return bytes_of_profile(profile);
}

TEST(AlphaAndInks, InksFollowTheirProfile) {
    const ScratchFolder scratch;
    cv::Mat stored(1, 6, CV_8UC4);
    cv::Mat inks(1, 6, CV_8UC4);
    const std::vector<cv::Vec4b> amounts{{0, 0, 0, 0},   {255, 0, 0, 0}, {0, 255, 0, 0},
                                         {0, 0, 255, 0}, {0, 0, 0, 102}, {0, 0, 0, 255}};
    for (int x = 0; x < 6; ++x) {
        inks.at<cv::Vec4b>(0, x) = amounts[static_cast<std::size_t>(x)];
        stored.at<cv::Vec4b>(0, x) = cv::Vec4b::all(255) - inks.at<cv::Vec4b>(0, x);
    }
    cv::Mat large;  // Each of 8 x 8 pixels, so that a JPEG keeps it.
    cv::resize(stored, large, {48, 8}, 0, 0, cv::INTER_NEAREST);
    scratch.put("inks.jpg", jpeg_with_profile(cmyk_jpeg(large), ink_profile()));
    cv::resize(inks, large, {48, 8}, 0, 0, cv::INTER_NEAREST);
    write_tiff(scratch / "inks.tif", large, [](OIIO::ImageSpec& spec) {
        spec.attribute("tiff:ColorSpace", "CMYK");
        spec.channelnames = {"C", "M", "Y", "K"};
        spec.alpha_channel = -1;
        const Bytes profile = ink_profile();
        spec.attribute("ICCProfile",
                       OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                       profile.data());
    });
    for (const std::string name : {"inks.jpg", "inks.tif"}) {
        const SrgbPicture read = read_srgb_picture(scratch / name);
        EXPECT_EQ(read.conversion.from, "Some inks") << name;
        EXPECT_EQ(read.conversion.profile_fault, "") << name;
        for (int x = 0; x < 6; ++x) {
            const cv::Vec4b ink = amounts[static_cast<std::size_t>(x)];
            const double lightness = 100 * lightness_of_inks(ink[0] / 255.0, ink[1] / 255.0,
                                                             ink[2] / 255.0, ink[3] / 255.0);
            const double light =
                lightness > 8 ? std::pow((lightness + 16) / 116, 3) : lightness * 27.0 / 24389.0;
            const Rgb8 pixel = read.picture(8 * x + 4, 4);
            EXPECT_NEAR(pixel.r, 255 * srgb_of_light(light), 2) << name << " " << x;
            EXPECT_NEAR(pixel.g, pixel.r, 1) << name << " " << x;
            EXPECT_NEAR(pixel.b, pixel.r, 1) << name << " " << x;
        }
    }
    scratch.put("without.jpg", cmyk_jpeg(large));
    EXPECT_EQ(read_srgb_picture(scratch / "without.jpg").conversion.from, "CMYK without a profile");
}

/// 16 x 16 pixels of one colour, whose first ink alone is stored at full size: by Pillow.
Bytes unusually_subsampled_jpeg() {
    return {0xff, 0xd8, 0xff, 0xee, 0x00, 0x0e, 0x41, 0x64, 0x6f, 0x62, 0x65, 0x00, 0x64, 0x00,
            0x00, 0x00, 0x00, 0x00, 0xff, 0xdb, 0x00, 0x43, 0x00, 0x10, 0x0b, 0x0c, 0x0e, 0x0c,
            0x0a, 0x10, 0x0e, 0x0d, 0x0e, 0x12, 0x11, 0x10, 0x13, 0x18, 0x28, 0x1a, 0x18, 0x16,
            0x16, 0x18, 0x31, 0x23, 0x25, 0x1d, 0x28, 0x3a, 0x33, 0x3d, 0x3c, 0x39, 0x33, 0x38,
            0x37, 0x40, 0x48, 0x5c, 0x4e, 0x40, 0x44, 0x57, 0x45, 0x37, 0x38, 0x50, 0x6d, 0x51,
            0x57, 0x5f, 0x62, 0x67, 0x68, 0x67, 0x3e, 0x4d, 0x71, 0x79, 0x70, 0x64, 0x78, 0x5c,
            0x65, 0x67, 0x63, 0xff, 0xc0, 0x00, 0x14, 0x08, 0x00, 0x10, 0x00, 0x10, 0x04, 0x43,
            0x22, 0x00, 0x4d, 0x11, 0x00, 0x59, 0x11, 0x00, 0x4b, 0x11, 0x00, 0xff, 0xc4, 0x00,
            0x17, 0x00, 0x01, 0x01, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
            0x00, 0x00, 0x00, 0x00, 0x00, 0x07, 0x01, 0x06, 0xff, 0xc4, 0x00, 0x14, 0x10, 0x01,
            0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
            0x00, 0x00, 0xff, 0xda, 0x00, 0x0e, 0x04, 0x43, 0x00, 0x4d, 0x00, 0x59, 0x00, 0x4b,
            0x00, 0x00, 0x3f, 0x00, 0xa0, 0x00, 0xc4, 0xfd, 0xd0, 0x3f, 0xff, 0xd9};
}

TEST(AlphaAndInks, InksOfAnyResolutionAreRead) {
    const ScratchFolder scratch;
    scratch.put("inks.jpg", unusually_subsampled_jpeg());
    const ImageSize size = read_image_size(scratch / "inks.jpg");
    EXPECT_EQ(size.width_px, 16);
    EXPECT_EQ(size.height_px, 16);
    const ColorImage picture = read_color_image(scratch / "inks.jpg");
    for (const Rgb8& pixel : picture.pixels()) {
        EXPECT_NEAR(pixel.r, 191, 3);
        EXPECT_NEAR(pixel.g, 95, 3);
        EXPECT_NEAR(pixel.b, 0, 3);
    }
    Bytes half = unusually_subsampled_jpeg();
    half.resize(half.size() / 2);
    scratch.put("half.jpg", half);
    EXPECT_THROW((void)read_color_image(scratch / "half.jpg"), Error);
}

}  // namespace
}  // namespace lumi
