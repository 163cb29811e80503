#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/calib/pictures/color_pictures.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

TEST(ColorProfile, JpegPngAndTiffOfADisplayP3ProfileBecomeSrgb) {
    const ScratchFolder scratch;
    const Bytes jpeg = jpeg_of(scratch, colors());
    write_png(scratch / "plain.png", colors());
    const Bytes png = read_whole_file(scratch / "plain.png");
    const Bytes profile = display_p3_profile();
    scratch.put("p3.jpg", jpeg_with_profile(jpeg, profile));
    scratch.put("p3 in parts.jpg", jpeg_with_profile(jpeg, profile, 3));
    scratch.put("p3.png", png_with_profile(png, profile));
    write_tiff(scratch / "p3.tif", matrix_of_colors(colors()), profile);
    for (const std::string name : {"p3.jpg", "p3 in parts.jpg", "p3.png", "p3.tif"}) {
        const SrgbPicture read = read_srgb_picture(scratch / name);
        EXPECT_EQ(read.conversion.from, "Display P3") << name;
        EXPECT_EQ(read.conversion.profile_fault, "") << name;
        const ColorImage stored =
            name.ends_with(".jpg") ? read_color_image(scratch / "plain.jpg") : colors();
        expect_converted(stored, read.picture, kDisplayP3Primaries, light_of_srgb);
        EXPECT_EQ(read_color_image(scratch / name), read.picture) << name;
    }
}

TEST(ColorProfile, AGreyOfAnyRgbProfileStaysGrey) {
    const ScratchFolder scratch;
    ColorImage greys(256, 1);
    for (int x = 0; x < 256; ++x) {
        const auto level = static_cast<std::uint8_t>(x);
        greys(x, 0) = {level, level, level};
    }
    write_png(scratch / "plain.png", greys);
    const Bytes png = read_whole_file(scratch / "plain.png");
    scratch.put("p3.png", png_with_profile(png, display_p3_profile()));
    EXPECT_EQ(read_color_image(scratch / "p3.png"), greys) << "its curve is that of sRGB";
    scratch.put("adobe.png", png_with_profile(png, rgb_profile_of("Adobe", kAdobePrimaries,
                                                                  cmsBuildGamma(nullptr, 2.2))));
    const ColorImage adobe = read_color_image(scratch / "adobe.png");
    for (int x = 0; x < 256; ++x) {
        const double expected = 255 * srgb_of_light(std::pow(x / 255.0, 2.2));
        EXPECT_NEAR(adobe(x, 0).g, expected, 0.6);
        EXPECT_EQ(adobe(x, 0).r, adobe(x, 0).g);
        EXPECT_EQ(adobe(x, 0).b, adobe(x, 0).g);
    }
}

TEST(ColorProfile, ProfilesOfSrgbLeaveEveryByte) {
    const ScratchFolder scratch;
    const Bytes jpeg = jpeg_of(scratch, wavy_picture(64, 48));
    const ColorImage plain = read_color_image(scratch / "plain.jpg");
    const std::vector<Bytes> profiles{
        bytes_of_profile(cmsCreate_sRGBProfile()),
        rgb_profile_of("rounded otherwise", {0.64005, 0.32995, 0.30005, 0.59995, 0.15005, 0.05995},
                       srgb_tone_curve())};
    for (const Bytes& profile : profiles) {
        scratch.put("srgb.jpg", jpeg_with_profile(jpeg, profile));
        const SrgbPicture read = read_srgb_picture(scratch / "srgb.jpg");
        EXPECT_EQ(read.conversion.from, "");
        EXPECT_EQ(read.conversion.profile_fault, "");
        EXPECT_EQ(read.picture, plain);
    }
    scratch.put("other curve.jpg",
                jpeg_with_profile(
                    jpeg, rgb_profile_of("gamma", kSrgbPrimaries, cmsBuildGamma(nullptr, 2.2))));
    EXPECT_EQ(read_srgb_picture(scratch / "other curve.jpg").conversion.from, "gamma");
}

TEST(ColorProfile, ADamagedProfileIsNamedAndThePictureTakenAsSrgb) {
    const ScratchFolder scratch;
    const Bytes profile = display_p3_profile();
    const Bytes half(profile.begin(), profile.begin() + 200);
    const Bytes none(300, 7);
    write_png(scratch / "plain.png", colors());
    const Bytes png = read_whole_file(scratch / "plain.png");
    for (const Bytes& damaged : {half, none}) {
        const Bytes jpeg = jpeg_of(scratch, colors());
        scratch.put("damaged.jpg", jpeg_with_profile(jpeg, damaged));
        scratch.put("damaged.png", png_with_profile(png, damaged));
        write_tiff(scratch / "damaged.tif", matrix_of_colors(colors()), damaged);
        for (const std::string name : {"damaged.jpg", "damaged.png", "damaged.tif"}) {
            const SrgbPicture read = read_srgb_picture(scratch / name);
            EXPECT_EQ(read.conversion.profile_fault, "is damaged") << name;
            EXPECT_EQ(read.conversion.from, "") << name;
            EXPECT_EQ(read.picture,
                      name == "damaged.jpg" ? read_color_image(scratch / "plain.jpg") : colors())
                << name;
        }
    }
    scratch.put("uncompressed.png", png_with_chunk(png, "iCCP", {'i', 0, 0, 1, 2, 3}));
    EXPECT_EQ(read_srgb_picture(scratch / "uncompressed.png").conversion.profile_fault,
              "is damaged");
}

TEST(ColorProfile, EveryTruncationOfAProfileIsNamedOrHarmless) {
    const ScratchFolder scratch;
    const Bytes jpeg = jpeg_of(scratch, colors());
    const ColorImage stored = read_color_image(scratch / "plain.jpg");
    const Bytes profile = display_p3_profile();
    scratch.put("whole.jpg", jpeg_with_profile(jpeg, profile));
    const ColorImage whole = read_color_image(scratch / "whole.jpg");
    std::size_t named = 0;
    for (std::size_t length = 1; length < profile.size(); ++length) {
        const Bytes part(profile.begin(), profile.begin() + static_cast<std::ptrdiff_t>(length));
        scratch.put("part.jpg", jpeg_with_profile(jpeg, part));
        const SrgbPicture read = read_srgb_picture(scratch / "part.jpg");
        const bool is_named = !read.conversion.profile_fault.empty();
        named += is_named ? 1 : 0;
        EXPECT_EQ(read.picture, is_named ? stored : whole) << length;
    }
    EXPECT_GT(named, profile.size() / 2);
}

TEST(ColorProfile, AProfileForOtherPicturesIsPassedOver) {
    const ScratchFolder scratch;
    const Bytes jpeg = jpeg_of(scratch, colors());
    cmsToneCurve* curve = cmsBuildGamma(nullptr, 1.8);
    cmsHPROFILE grey = cmsCreateGrayProfile(cmsD50_xyY(), curve);
    cmsFreeToneCurve(curve);
    scratch.put("grey profile.jpg", jpeg_with_profile(jpeg, bytes_of_profile(grey)));
    const SrgbPicture read = read_srgb_picture(scratch / "grey profile.jpg");
    EXPECT_EQ(read.conversion.profile_fault, "is for pictures of another kind");
    EXPECT_EQ(read.picture, read_color_image(scratch / "plain.jpg"));
}

TEST(ColorProfile, GreyPicturesFollowAGreyProfile) {
    const ScratchFolder scratch;
    cmsToneCurve* curve = cmsBuildGamma(nullptr, 1.8);
    const Bytes profile = bytes_of_profile(cmsCreateGrayProfile(cmsD50_xyY(), curve));
    cmsFreeToneCurve(curve);
    cv::Mat greys(1, 256, CV_8UC1);
    cv::Mat deep_greys(1, 256, CV_16UC1);
    for (int x = 0; x < 256; ++x) {
        greys.at<std::uint8_t>(0, x) = static_cast<std::uint8_t>(x);
        deep_greys.at<std::uint16_t>(0, x) = static_cast<std::uint16_t>(257 * x);
    }
    write_tiff(scratch / "8 bits.tif", greys, profile);
    write_tiff(scratch / "16 bits.tif", deep_greys, profile);
    Bytes png;
    cv::imencode(".png", greys, png);
    scratch.put("grey.png", png_with_profile(png, profile));
    for (const std::string name : {"8 bits.tif", "16 bits.tif", "grey.png"}) {
        const SrgbPicture read = read_srgb_picture(scratch / name);
        EXPECT_NE(read.conversion.from, "") << name;
        for (int x = 0; x < 256; ++x) {
            const Rgb8 pixel = read.picture(x, 0);
            EXPECT_NEAR(pixel.r, 255 * srgb_of_light(std::pow(x / 255.0, 1.8)), 1.0)
                << name << " " << x;
            EXPECT_EQ(pixel, (Rgb8{pixel.r, pixel.r, pixel.r})) << name << " " << x;
        }
    }
}

/// What cameras write of Adobe RGB, as far as it matters: IFD entries within a segment.
Bytes exif_of_adobe_rgb(bool big_endian, const std::string& interoperability) {
    Bytes exif{'E', 'x', 'i', 'f', 0, 0};
    const std::string header =
        big_endian ? std::string("MM\0*\0\0\0\x08", 8) : std::string("II*\0\x08\0\0\0", 8);
    const std::string color_space = big_endian
                                        ? std::string("\xa0\x01\0\x03\0\0\0\x01\xff\xff\0\0", 12)
                                        : std::string("\x01\xa0\x03\0\x01\0\0\0\xff\xff\0\0", 12);
    const std::string index = (big_endian ? std::string("\0\x01\0\x02\0\0\0\x04", 8)
                                          : std::string("\x01\0\x02\0\x04\0\0\0", 8)) +
                              interoperability + std::string(1, '\0');
    for (const std::string& part : {header, color_space, index}) {
        exif.insert(exif.end(), part.begin(), part.end());
    }
    return exif;
}

TEST(ColorProfile, AdobeRgbByExifAloneIsConverted) {
    const ScratchFolder scratch;
    const Bytes jpeg = jpeg_of(scratch, colors());
    const ColorImage stored = read_color_image(scratch / "plain.jpg");
    for (const bool big_endian : {false, true}) {
        scratch.put("adobe.jpg",
                    jpeg_with_segment(jpeg, 0xe1, exif_of_adobe_rgb(big_endian, "R03")));
        const SrgbPicture read = read_srgb_picture(scratch / "adobe.jpg");
        EXPECT_EQ(read.conversion.from, "Adobe RGB (by EXIF)");
        expect_converted(stored, read.picture, kAdobePrimaries, adobe_curve);
        scratch.put("srgb.jpg",
                    jpeg_with_segment(jpeg, 0xe1, exif_of_adobe_rgb(big_endian, "R98")));
        EXPECT_EQ(read_color_image(scratch / "srgb.jpg"), stored);
    }
    const Bytes both = jpeg_with_profile(
        jpeg_with_segment(jpeg, 0xe1, exif_of_adobe_rgb(false, "R03")), display_p3_profile());
    scratch.put("both.jpg", both);
    EXPECT_EQ(read_srgb_picture(scratch / "both.jpg").conversion.from, "Display P3")
        << "the profile counts first";
}

}  // namespace
}  // namespace lumi
