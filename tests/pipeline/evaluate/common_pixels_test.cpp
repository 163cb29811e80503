#include "pipeline/evaluate/common_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "pipeline/evaluate/image_metrics.h"

namespace lumi {
namespace {

constexpr int kWidth = 4;

/// Off by so much in each column; a column off by less than 0 is not covered.
Frame off_by(const std::array<int, kWidth>& errors) {
    Frame frame{ColorImage(kWidth, 1), GrayImage(kWidth, 1, 255), {}};
    for (int x = 0; x < kWidth; ++x) {
        const int error = errors[static_cast<std::size_t>(x)];
        const auto value = static_cast<std::uint8_t>(std::max(0, error));
        frame.color(x, 0) = {value, value, value};
        if (error < 0) frame.coverage(x, 0) = 0;
    }
    return frame;
}

double db_of(double error) { return psnr_of_mean_square(error * error); }

TEST(CommonPixels, AreThoseThatEveryMethodWithDepthCovers) {
    const ColorImage black(kWidth, 1);
    CommonPixels common;
    common.add({.name = "careful", .has_say = true}, "a", black, off_by({10, 10, -1, -1}));
    common.add({.name = "bold", .has_say = true}, "a", black, off_by({-1, 20, 90, 90}));
    common.add({.name = "flat", .has_say = false}, "a", black, off_by({-1, 30, -1, 90}));
    // Column 1 is common: what others cover beside it counts for none.
    EXPECT_DOUBLE_EQ(common.psnr_db("careful", "a").value(), db_of(10));
    EXPECT_DOUBLE_EQ(common.psnr_db("bold", "a").value(), db_of(20));
    EXPECT_DOUBLE_EQ(common.psnr_db("flat", "a").value(), db_of(30));
    EXPECT_DOUBLE_EQ(common.share(), 0.25);
}

TEST(CommonPixels, OfViewsThatHaveNoneAreNoPartOfTheMean) {
    const ColorImage black(kWidth, 1);
    CommonPixels common;
    common.add({.name = "one", .has_say = true}, "a", black, off_by({10, 10, 10, 10}));
    common.add({.name = "one", .has_say = true}, "b", black, off_by({-1, -1, -1, -1}));
    EXPECT_DOUBLE_EQ(common.mean_psnr_db("one").value(), db_of(10));
    EXPECT_FALSE(common.psnr_db("one", "b").has_value());
    EXPECT_DOUBLE_EQ(common.share(), 0.5);
    common.add({.name = "other", .has_say = true}, "a", black, off_by({-1, -1, -1, -1}));
    EXPECT_FALSE(common.mean_psnr_db("one").has_value());
}

TEST(FilledFrame, HasOtherColorsWhereItKnowsNothing) {
    const Frame frame = filled(off_by({10, -1, 30, -1}), ColorImage(kWidth, 1, {7, 7, 7}));
    EXPECT_EQ(frame.color(0, 0).r, 10);
    EXPECT_EQ(frame.color(1, 0).r, 7);
    EXPECT_EQ(frame.color(2, 0).r, 30);
    EXPECT_EQ(frame.coverage(1, 0), 0) << "it still knows nothing there";
}

}  // namespace
}  // namespace lumi
