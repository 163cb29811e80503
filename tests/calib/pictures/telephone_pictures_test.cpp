#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "calib/pictures/image_format.h"
#include "calib/work/error.h"
#include "tests/calib/heif_pictures.h"
#include "tests/calib/pictures/color_pictures.h"
#include "tests/calib/test_pictures.h"
#include "tests/calib/webp_pictures.h"

/// What encoders leave behind is theirs; lumi only reads.
extern "C" const char* __lsan_default_suppressions() { return "leak:libx265\nleak:libaom\n"; }

namespace lumi {
namespace {

double largest_difference_of(const ColorImage& a, const ColorImage& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i)
        largest = std::max(
            largest, (levels_of(a.pixels()[i]) - levels_of(b.pixels()[i])).cwiseAbs().maxCoeff());
    return largest;
}

/// Without edges, which compression would ring at.
ColorImage smooth_picture() {
    ColorImage picture(96, 64);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            picture(x, y) = {static_cast<std::uint8_t>(40 + 2 * x),
                             static_cast<std::uint8_t>(230 - 3 * y),
                             static_cast<std::uint8_t>(60 + x + y)};
    return picture;
}

std::string code_of_reading(const std::filesystem::path& path,
                            std::size_t max_pixels = std::size_t{1} << 28) {
    try {
        static_cast<void>(read_color_image(path, max_pixels));
    } catch (const Error& error) {
        return error.code();
    }
    return "";
}

TEST(TelephonePictures, HeicAndAvifAreReadByTheirContent) {
    const ScratchFolder scratch;
    scratch.put("heic.jpg", heif_of(smooth_picture()));
    scratch.put("avif.jpg", heif_of(smooth_picture(), {.codec = heif_compression_AV1}));
    for (const char* name : {"heic.jpg", "avif.jpg"}) {
        const SrgbPicture read = read_srgb_picture(scratch / name);
        ASSERT_EQ(read.picture.width(), 96) << name;
        ASSERT_EQ(read.picture.height(), 64) << name;
        EXPECT_LE(largest_difference_of(read.picture, smooth_picture()), 4) << name;
        EXPECT_EQ(read.conversion.from, "") << name;
        EXPECT_EQ(read.conversion.profile_fault, "") << name;
        const ImageSize size = read_image_size(scratch / name);
        EXPECT_EQ(size.width_px, 96);
        EXPECT_EQ(size.height_px, 64);
    }
}

TEST(TelephonePictures, WhatTurnsTheDisplayLeavesTheRasterAsTheSensorHadIt) {
    const ScratchFolder scratch;
    scratch.put("level.heic", heif_of(smooth_picture()));
    Bytes turned = heif_of(smooth_picture(), {.turned = heif_orientation_rotate_90_cw});
    swap_stored_size(turned);
    scratch.put("turned.heic", turned);
    EXPECT_EQ(read_color_image(scratch / "turned.heic"), read_color_image(scratch / "level.heic"));
    EXPECT_EQ(read_image_size(scratch / "turned.heic").width_px, 96);
}

TEST(TelephonePictures, MoreThanEightBitsReachFromBlackToWhite) {
    const ScratchFolder scratch;
    ColorImage picture(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 32; x < 64; ++x) picture(x, y) = {255, 255, 255};
    scratch.put("deep.heic", heif_of(picture, {.bits = 10}));
    EXPECT_LE(largest_difference_of(read_color_image(scratch / "deep.heic"), picture), 3);
}

TEST(TelephonePictures, WhatIsTransparentIsBlack) {
    const ScratchFolder scratch;
    scratch.put("cut out.heic", heif_of(smooth_picture(), {.has_alpha = true}));
    const SrgbPicture read = read_srgb_picture(scratch / "cut out.heic");
    EXPECT_NEAR(read.conversion.hidden_share, 0.5, 0.02);
    EXPECT_EQ(read.picture(90, 30), Rgb8());
    EXPECT_NEAR(read.picture(10, 30).g, 140, 4);
}

TEST(TelephonePictures, DisplayP3IsConvertedHoweverItIsSaid) {
    const ScratchFolder scratch;
    const ColorImage wide = resized(colors(), 144, 144);
    // Tagged as sRGB they are stored alike: what the compression did is the same.
    scratch.put("plain.heic", heif_of(wide, {.coded = CodedColors{1, 13}}));
    const ColorImage stored = read_color_image(scratch / "plain.heic");
    scratch.put("coded.heic", heif_of(wide, {.coded = CodedColors{12, 13}}));
    scratch.put("profile.heic",
                heif_of(wide, {.icc_profile = display_p3_profile(), .coded = CodedColors{1, 13}}));
    for (const char* name : {"coded.heic", "profile.heic"}) {
        const SrgbPicture read = read_srgb_picture(scratch / name);
        EXPECT_EQ(read.conversion.from, "Display P3") << name;
        expect_converted(stored, read.picture, kDisplayP3Primaries, light_of_srgb);
    }
}

TEST(TelephonePictures, CodedColorsOfAPngCountBeforeItsProfile) {
    const ScratchFolder scratch;
    write_png(scratch / "plain.png", colors());
    const Bytes png = read_whole_file(scratch / "plain.png");
    scratch.put("p3.png", png_with_chunk(png, "cICP", {12, 13, 0, 1}));
    expect_converted(colors(), read_color_image(scratch / "p3.png"), kDisplayP3Primaries,
                     light_of_srgb);
    scratch.put("srgb.png",
                png_with_chunk(png_with_profile(png, display_p3_profile()), "cICP", {1, 13, 0, 1}));
    EXPECT_EQ(read_color_image(scratch / "srgb.png"), colors());
    scratch.put("strange.png", png_with_chunk(png, "cICP", {10, 13, 0, 1}));
    const SrgbPicture strange = read_srgb_picture(scratch / "strange.png");
    EXPECT_EQ(strange.picture, colors());
    EXPECT_NE(strange.conversion.profile_fault, "");
    scratch.put("pq.png", png_with_chunk(png, "cICP", {9, 16, 0, 1}));
    EXPECT_EQ(code_of_reading(scratch / "pq.png"), "E-IMAGE-FORMAT");
    scratch.put("hlg.png", png_with_chunk(png, "cICP", {9, 18, 0, 1}));
    EXPECT_EQ(read_srgb_picture(scratch / "hlg.png").conversion.from, "HLG (BT.2020)");
}

TEST(TelephonePictures, PqIsRefusedByName) {
    const ScratchFolder scratch;
    scratch.put("hdr.heic", heif_of(smooth_picture(), {.coded = CodedColors{9, 16}}));
    EXPECT_EQ(code_of_reading(scratch / "hdr.heic"), "E-IMAGE-FORMAT");
}

TEST(TelephonePictures, AFileThatEndsEarlyIsRefusedWhereverItEnds) {
    const ScratchFolder scratch;
    for (const Bytes& whole :
         {heif_of(wavy_picture(96, 64)), webp_of(wavy_picture(96, 64)),
          webp_with(webp_of(wavy_picture(96, 64)), 96, 64, display_p3_profile(), {})}) {
        ASSERT_GT(whole.size(), 100U);
        for (int part = 1; part < 40; ++part) {
            const auto length = static_cast<std::ptrdiff_t>(whole.size()) * part / 40;
            scratch.put("cut", Bytes(whole.begin(), whole.begin() + length));
            const std::string code = code_of_reading(scratch / "cut");
            EXPECT_TRUE(code == "E-IMAGE-TRUNCATED" || (code == "E-IMAGE-FORMAT" && length < 12))
                << part << ": " << code;
        }
    }
}

TEST(TelephonePictures, ADamagedFileIsReadOrRefusedAndNothingElse) {
    const ScratchFolder scratch;
    std::mt19937 random(5);
    int refused = 0;
    for (const Bytes& whole : {heif_of(wavy_picture(96, 64)), webp_of(wavy_picture(96, 64))}) {
        for (int trial = 0; trial < 60; ++trial) {
            Bytes damaged = whole;
            // Every second time in the headers alone.
            const std::size_t end =
                trial % 2 == 0 ? whole.size() : std::min<std::size_t>(400, whole.size());
            for (int i = 0; i < 4; ++i)
                damaged[random() % end] = static_cast<std::uint8_t>(random());
            scratch.put("damaged", damaged);
            refused += code_of_reading(scratch / "damaged", std::size_t{1} << 22).empty() ? 0 : 1;
        }
    }
    EXPECT_GT(refused, 20);
}

TEST(TelephonePictures, MorePixelsThanAreAllowedAreNotDecoded) {
    const ScratchFolder scratch;
    scratch.put("big.heic", heif_of(smooth_picture()));
    scratch.put("big.webp", webp_of(smooth_picture()));
    EXPECT_EQ(code_of_reading(scratch / "big.heic", 96 * 64 - 1), "E-IMAGE-TOOBIG");
    EXPECT_EQ(code_of_reading(scratch / "big.webp", 96 * 64 - 1), "E-IMAGE-TOOBIG");
    EXPECT_EQ(code_of_reading(scratch / "big.heic", 96 * 64), "");
}

TEST(TelephonePictures, WebPIsReadWithItsProfile) {
    const ScratchFolder scratch;
    const Bytes plain = webp_of(colors());
    scratch.put("plain.webp", plain);
    EXPECT_EQ(read_color_image(scratch / "plain.webp"), colors());
    EXPECT_EQ(read_image_size(scratch / "plain.webp").width_px, 18);
    scratch.put("p3.webp", webp_with(plain, 18, 18, display_p3_profile(), {}));
    const SrgbPicture read = read_srgb_picture(scratch / "p3.webp");
    EXPECT_EQ(read.conversion.from, "Display P3");
    expect_converted(colors(), read.picture, kDisplayP3Primaries, light_of_srgb);
}

}  // namespace
}  // namespace lumi
