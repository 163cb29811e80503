#include "calib/ingest/own_bars.h"

#include <gtest/gtest.h>

#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

constexpr int kBarredWidth = 160;
constexpr int kBarredHeight = 120;
constexpr ImageRectangle kUnbarred{0, 0, kBarredWidth, kBarredHeight};

/// Bars of such a grey level at all sides, as many pixels wide.
ColorImage barred(int above, int below, int left, int right, std::uint8_t level = 0) {
    ColorImage picture = wavy_picture(kBarredWidth, kBarredHeight, 5.0);
    for (int y = 0; y < kBarredHeight; ++y) {
        for (int x = 0; x < kBarredWidth; ++x) {
            if (y < above || y >= kBarredHeight - below || x < left || x >= kBarredWidth - right)
                picture(x, y) = {level, level, level};
        }
    }
    return picture;
}

TEST(OwnBars, BlackOrWhiteOnesAboveAndBelowAreCutOffWithTwoMoreRows) {
    const ImageRectangle between{0, 16, kBarredWidth, kBarredHeight - 32};
    EXPECT_EQ(picture_between_own_bars(barred(14, 14, 0, 0)), between);
    EXPECT_EQ(picture_between_own_bars(barred(14, 14, 0, 0, 250)), between);
}

TEST(OwnBars, ThoseAtTheSidesAreCutOff) {
    EXPECT_EQ(picture_between_own_bars(barred(0, 0, 20, 20)),
              (ImageRectangle{22, 0, kBarredWidth - 44, kBarredHeight}));
}

TEST(OwnBars, APhotographHasNone) {
    EXPECT_EQ(picture_between_own_bars(barred(0, 0, 0, 0)), kUnbarred);
}

TEST(OwnBars, OneAloneAndUnequalOnesAndGreyOnesAreNone) {
    EXPECT_EQ(picture_between_own_bars(barred(14, 0, 0, 0)), kUnbarred);
    EXPECT_EQ(picture_between_own_bars(barred(14, 20, 0, 0)), kUnbarred);
    EXPECT_EQ(picture_between_own_bars(barred(14, 14, 0, 0, 120)), kUnbarred);
}

TEST(OwnBars, BarsThatLeaveLessThanHalfAreNone) {
    EXPECT_EQ(picture_between_own_bars(barred(31, 31, 0, 0)), kUnbarred);
}

TEST(OwnBars, ABlackPhotographHasNone) {
    EXPECT_EQ(picture_between_own_bars(barred(kBarredHeight, 0, 0, 0)), kUnbarred);
}

/// Above and below a subject that does not reach from side to side.
TEST(OwnBars, ABackdropIsNone) {
    EXPECT_EQ(picture_between_own_bars(barred(14, 14, 45, 45, 250)), kUnbarred);
}

}  // namespace
}  // namespace lumi
