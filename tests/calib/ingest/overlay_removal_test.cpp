#include "calib/ingest/overlay_removal.h"

#include <gmock/gmock.h>

#include "calib/pictures/image_io.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

constexpr int kPrintedWidth = 160;
constexpr int kPrintedHeight = 120;
constexpr int kPrinted = 12;
constexpr int kBar_px = 14;

/// Bars above and below, and a label, over a scene that passes by unevenly.
void print_over(ColorImage& picture) {
    for (int y = 0; y < kPrintedHeight; ++y) {
        for (int x = 0; x < kPrintedWidth; ++x) {
            if (y < kBar_px || y >= kPrintedHeight - kBar_px) picture(x, y) = {0, 0, 0};
            if (x >= 100 && x < 130 && y >= 60 && y < 75) picture(x, y) = {255, 255, 255};
        }
    }
}

void write_photographs(const ScratchFolder& scratch, int photographs = kPrinted) {
    std::mt19937 random(8);
    for (int i = 0; i < photographs; ++i) {
        ColorImage picture =
            wavy_picture(kPrintedWidth, kPrintedHeight, static_cast<double>(random() % 400));
        print_over(picture);
        write_png(scratch / "photos" / (std::to_string(100 + i) + ".png"), picture);
    }
}

IngestResult printed_photographs(const ScratchFolder& scratch, const IngestOptions& options) {
    SilentProgress progress;
    return ingest(scratch / "photos", options, scratch / "copies", 2, progress);
}

TEST(OverlayRemoval, CutsBarsOffAndPaintsLabelsOver) {
    const ScratchFolder scratch;
    write_photographs(scratch);
    const IngestResult result = printed_photographs(scratch, {});
    ASSERT_EQ(result.overlays.size(), 1U);
    const RemovedOverlay& overlay = result.overlays[0];
    EXPECT_EQ(overlay.photographs, kPrinted);
    EXPECT_EQ(overlay.picture,
              (ImageRectangle{0, kBar_px + 2, kPrintedWidth, kPrintedHeight - 2 * kBar_px - 4}));
    EXPECT_GT(overlay.share, 30.0 * 15.0 / (kPrintedWidth * kPrintedHeight));
    EXPECT_LT(overlay.share, 0.08);
    const GrayImage mask = read_gray_png(overlay.mask_path);
    for (const Photograph& photograph : result.photographs) {
        const ColorImage copy = read_color_image(photograph.picture_path);
        ASSERT_EQ(copy.width(), photograph.width_px);
        ASSERT_EQ(copy.height(), photograph.height_px);
        ASSERT_EQ(copy.height(), overlay.picture.height_px);
        const ColorImage taken = read_color_image(scratch / "photos" / photograph.name);
        for (int y = 0; y < copy.height(); ++y) {
            for (int x = 0; x < copy.width(); ++x) {
                const Rgb8 before = taken(x, y + overlay.picture.top);
                if (mask(x, y) != 0) {
                    EXPECT_EQ(copy(x, y), before);
                } else {
                    EXPECT_NE(copy(x, y), (Rgb8{255, 255, 255}));
                }
            }
        }
    }
}

TEST(OverlayRemoval, LeavesPhotographsAsTheyAreWhenAskedTo) {
    const ScratchFolder scratch;
    write_photographs(scratch);
    IngestOptions options;
    options.keep_overlays = true;
    const IngestResult result = printed_photographs(scratch, options);
    EXPECT_TRUE(result.overlays.empty());
    for (const Photograph& photograph : result.photographs) {
        EXPECT_EQ(read_color_image(photograph.picture_path),
                  read_color_image(scratch / "photos" / photograph.name));
    }
}

TEST(OverlayRemoval, PaintsLabelsOverInTheWholeRasterWhereBarsHaveToStay) {
    const ScratchFolder scratch;
    write_photographs(scratch);
    IngestOptions options;
    options.crop_bars = false;
    const IngestResult result = printed_photographs(scratch, options);
    ASSERT_EQ(result.overlays.size(), 1U);
    EXPECT_EQ(result.overlays[0].picture, (ImageRectangle{0, 0, kPrintedWidth, kPrintedHeight}));
    const GrayImage mask = read_gray_png(result.overlays[0].mask_path);
    EXPECT_EQ(mask(115, 67), 0);
    EXPECT_EQ(mask(115, 5), 255);
    for (const Photograph& photograph : result.photographs) {
        const ColorImage copy = read_color_image(photograph.picture_path);
        ASSERT_EQ(copy.height(), kPrintedHeight);
        EXPECT_EQ(copy(80, 3), (Rgb8{0, 0, 0}));
        EXPECT_NE(copy(115, 67), (Rgb8{255, 255, 255}));
    }
}

/// Known lenses are told for originals: 121 rows become 60, and 60 times two are not 121.
TEST(OverlayRemoval, OriginalsKeepTheirSizeWhereNothingIsCutOff) {
    const ScratchFolder scratch;
    std::mt19937 random(8);
    for (int i = 0; i < kPrinted; ++i) {
        ColorImage picture = wavy_picture(242, 121, static_cast<double>(random() % 400));
        for (int y = 60; y < 90; ++y) {
            for (int x = 100; x < 160; ++x) picture(x, y) = {255, 255, 255};
        }
        write_png(scratch / "photos" / (std::to_string(100 + i) + ".png"), picture);
    }
    IngestOptions options;
    options.max_width_px = 121;
    options.min_width_px = 32;
    const IngestResult result = printed_photographs(scratch, options);
    ASSERT_EQ(result.overlays.size(), 1U);
    ASSERT_NE(2 * result.photographs.front().height_px, 121);
    EXPECT_EQ(result.photographs.front().original_width_px, 242);
    EXPECT_EQ(result.photographs.front().original_height_px, 121);
}

TEST(OverlayRemoval, AsksEachSizeForItself) {
    const ScratchFolder scratch;
    write_photographs(scratch);
    for (int i = 0; i < kFewestForOverlay - 1; ++i) {
        ColorImage picture = wavy_picture(kPrintedWidth + 8, kPrintedHeight, 37.0 * i);
        print_over(picture);
        write_png(scratch / "photos" / (std::to_string(200 + i) + ".png"), picture);
    }
    const IngestResult result = printed_photographs(scratch, {});
    ASSERT_EQ(result.overlays.size(), 1U);
    for (const Photograph& photograph : result.photographs) {
        const bool is_of_few = photograph.name >= "200.png";
        EXPECT_EQ(photograph.height_px == kPrintedHeight, is_of_few) << photograph.name;
        EXPECT_EQ(photograph.original_height_px, photograph.height_px);
    }
}

/// More than are looked at first.
TEST(OverlayRemoval, TakesALabelOutOfManyPhotographs) {
    const ScratchFolder scratch;
    write_photographs(scratch, 30);
    const IngestResult result = printed_photographs(scratch, {});
    ASSERT_EQ(result.overlays.size(), 1U);
    EXPECT_EQ(result.overlays[0].photographs, 30);
}

TEST(OverlayRemoval, CutsOffBarsThatOnlySomePhotographsHave) {
    const ScratchFolder scratch;
    for (int i = 0; i < 8; ++i) {
        ColorImage picture = wavy_picture(kPrintedWidth, kPrintedHeight, 61.0 * i);
        for (int y = 0; y < kPrintedHeight; ++y) {
            const bool is_bar = y < kBar_px || y >= kPrintedHeight - kBar_px;
            for (int x = 0; x < kPrintedWidth; ++x)
                if (is_bar && i % 2 == 1) picture(x, y) = {0, 0, 0};
        }
        write_png(scratch / "photos" / (std::to_string(100 + i) + ".png"), picture);
    }
    const IngestResult result = printed_photographs(scratch, {});
    ASSERT_EQ(result.overlays.size(), 1U);
    EXPECT_EQ(result.overlays[0].photographs, 4);
    EXPECT_EQ(result.overlays[0].of_photographs, 8);
    const int between = kPrintedHeight - 2 * kBar_px - 4;
    for (std::size_t i = 0; i < result.photographs.size(); ++i) {
        const Photograph& photograph = result.photographs[i];
        EXPECT_EQ(photograph.height_px, i % 2 == 1 ? between : kPrintedHeight);
        EXPECT_EQ(read_color_image(photograph.picture_path).height(), photograph.height_px);
    }
    IngestOptions options;
    options.crop_bars = false;
    EXPECT_TRUE(printed_photographs(scratch, options).overlays.empty());
}

TEST(OverlayRemoval, SaysWhichPhotographsHadBars) {
    const RemovedOverlay overlay{8, 16, 640, 426, {0, 53, 640, 320}, 0, {}};
    EXPECT_EQ(text_of(overlay),
              "8 of 16 photographs of 640x426 pixels have bars of one colour, which were cut off: "
              "53 pixels above, 53 pixels below ([capture] keep_overlays = true leaves it in)");
}

TEST(OverlayRemoval, SaysWhatItDid) {
    const RemovedOverlay overlay{28, 28, 768, 512, {0, 56, 768, 400}, 0.024, "overlay-1.png"};
    EXPECT_EQ(text_of(overlay),
              "something stands still in all of 28 photographs of 768x512 pixels; bars were cut "
              "off: 56 pixels above, 56 pixels below; a stamp, logo, watermark or black corner was "
              "painted over: "
              "2.4 % of the picture ([capture] keep_overlays = true leaves it in)");
}

TEST(OverlayRemoval, MasksOfAnEarlierRunAreRemoved) {
    const ScratchFolder scratch;
    write_photographs(scratch);
    (void)printed_photographs(scratch, {});
    EXPECT_TRUE(std::filesystem::exists(scratch / "copies/overlay-1.png"));
    IngestOptions options;
    options.keep_overlays = true;
    (void)printed_photographs(scratch, options);
    EXPECT_FALSE(std::filesystem::exists(scratch / "copies/overlay-1.png"));
}

}  // namespace
}  // namespace lumi
