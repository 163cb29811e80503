#include "calib/pictures/drawn_mask.h"

#include <gtest/gtest.h>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

TEST(DrawnMask, IsReadByTheNameOfItsPhotograph) {
    const ScratchFolder folder;
    GrayImage drawn(480, 360, 255);
    for (int x = 0; x < 100; ++x) drawn(x, 7) = 0;
    write_png(folder.path() / "walk" / "one.png", drawn);
    const GrayImage mask = drawn_mask("walk/one.jpg", 240, 180, folder.path());
    EXPECT_EQ(mask(10, 3), 0);
    EXPECT_EQ(mask(60, 3), 255);
    EXPECT_EQ(mask(10, 5), 255);
}

TEST(DrawnMask, TheWholeNameComesBeforeTheStem) {
    const ScratchFolder folder;
    write_png(folder.path() / "one.png", GrayImage(240, 180, 255));
    write_png(folder.path() / "one.png.png", GrayImage(240, 180, 255));
    EXPECT_EQ(mask_file_of("one.jpg", folder.path()), folder.path() / "one.png");
    EXPECT_EQ(mask_file_of("one.png", folder.path()), folder.path() / "one.png.png");
}

TEST(DrawnMask, ANameThatIsTooLongWithItsEndingIsLookedForByItsStem) {
    const ScratchFolder folder;
    const std::string stem(250, 'a');
    write_png(folder.path() / "short.png", GrayImage(240, 180, 255));
    std::filesystem::rename(folder.path() / "short.png", folder.path() / (stem + ".png"));
    EXPECT_EQ(mask_file_of(stem + ".jpg", folder.path()), folder.path() / (stem + ".png"));
    EXPECT_EQ(mask_file_of(stem + "aaa.jpg", folder.path()), "");
}

TEST(DrawnMask, OfTwoPhotographsOfOneStemEachNeedsItsOwn) {
    const ScratchFolder folder;
    const auto code_of_names = [&](const std::vector<std::string>& names) {
        try {
            expect_own_masks(names, folder.path());
        } catch (const Error& error) {
            return error.code();
        }
        return std::string("none");
    };
    write_png(folder.path() / "one.png", GrayImage(240, 180, 255));
    write_png(folder.path() / "two.png", GrayImage(240, 180, 255));
    EXPECT_EQ(code_of_names({"one.jpg", "two.png", "none.png", "none.jpg"}), "none");
    EXPECT_EQ(code_of_names({"one.jpg", "two.png", "one.png"}), "E-MASK-SHARED");
    write_png(folder.path() / "one.jpg.png", GrayImage(240, 180, 255));
    EXPECT_EQ(code_of_names({"one.jpg", "two.png", "one.png"}), "none");
}

TEST(DrawnMask, RefusesWhatIsMissingMisshapenOrEmpty) {
    const ScratchFolder folder;
    const auto code = [&] {
        try {
            (void)drawn_mask("one.jpg", 240, 180, folder.path());
        } catch (const Error& error) {
            return error.code();
        }
        return std::string("none");
    };
    EXPECT_EQ(code(), "E-MASK-MISSING");
    write_png(folder.path() / "one.png", GrayImage(240, 240, 255));
    EXPECT_EQ(code(), "E-MASK-SIZE");
    write_png(folder.path() / "one.png", GrayImage(240, 180, 100));
    EXPECT_EQ(code(), "E-MASK-EMPTY");
    write_png(folder.path() / "one.png", GrayImage(240, 180, 255));
    EXPECT_EQ(code(), "none");
}

TEST(DrawnMask, MayHaveThreeEqualChannelsButNoColors) {
    const ScratchFolder folder;
    ColorImage drawn(240, 180, {255, 255, 255});
    drawn(10, 3) = {0, 0, 0};
    write_png(folder.path() / "one.png", drawn);
    const GrayImage mask = drawn_mask("one.jpg", 240, 180, folder.path());
    EXPECT_EQ(mask(10, 3), 0);
    EXPECT_EQ(mask(11, 3), 255);
    drawn(20, 3) = {255, 0, 0};
    write_png(folder.path() / "one.png", drawn);
    try {
        (void)drawn_mask("one.jpg", 240, 180, folder.path());
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-MASK-COLOR");
    }
}

TEST(DrawnMask, MayBeRoundedByAPixelInEitherSide) {
    const ScratchFolder folder;
    for (const auto& [width_px, height_px] : {std::pair{180, 241}, {181, 240}, {180, 240}}) {
        write_png(folder.path() / "one.png", GrayImage(width_px, height_px, 255));
        EXPECT_NO_THROW((void)drawn_mask("one.jpg", 180, 240, folder.path()))
            << width_px << "x" << height_px;
    }
}

}  // namespace
}  // namespace lumi
