#include "calib/ingest/black_corners.h"

#include <gtest/gtest.h>

#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

constexpr ImageRectangle kCornered{0, 0, 120, 90};
constexpr int kCornerSide = 20;

/// Photographs of something that passes by, black in the upper left corner: a square, or, where its
/// end is `loose`, another square in each.
StandingPixels with_black_corner(bool is_loose) {
    StandingPixels standing(kCornered.width_px, kCornered.height_px);
    for (int i = 0; i < 16; ++i) {
        ColorImage picture = wavy_picture(kCornered.width_px, kCornered.height_px, 37.0 * i);
        const int side = kCornerSide + (is_loose ? (7 * i) % 13 : 0);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) picture(x, y) = {0, 0, 0};
        standing.add(picture);
    }
    return standing;
}

TEST(BlackCorners, OneThatEndsAtTheSamePlaceInAllPhotographsIsFound) {
    const cv::Mat corners = black_corners(with_black_corner(false), kCornered);
    ASSERT_EQ(corners.size(), cv::Size(kCornered.width_px, kCornered.height_px));
    for (int y = 0; y < kCornered.height_px; ++y) {
        for (int x = 0; x < kCornered.width_px; ++x) {
            const int beyond = std::max(x, y) - kCornerSide;
            const bool is_between = beyond >= 0 && beyond < 3;
            if (is_between) continue;
            EXPECT_EQ(corners.at<std::uint8_t>(y, x), beyond < 0 ? 255 : 0) << x << ", " << y;
        }
    }
}

TEST(BlackCorners, WhatIsBlackThereInOnePhotographAndNotInAnotherIsNone) {
    EXPECT_EQ(cv::countNonZero(black_corners(with_black_corner(true), kCornered)), 0);
}

TEST(BlackCorners, ThereAreNoneInPhotographsOfWhatPassesBy) {
    StandingPixels standing(kCornered.width_px, kCornered.height_px);
    for (int i = 0; i < 16; ++i)
        standing.add(wavy_picture(kCornered.width_px, kCornered.height_px, 37.0 * i));
    EXPECT_EQ(cv::countNonZero(black_corners(standing, kCornered)), 0);
}

}  // namespace
}  // namespace lumi
