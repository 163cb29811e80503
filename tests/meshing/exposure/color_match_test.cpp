#include "meshing/exposure/color_match.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

/// Greys in two photographs, the second darker in red and brighter in blue.
std::vector<SharedColor> greys_in_another_light() {
    std::vector<SharedColor> shared;
    for (int level = 20; level < 200; ++level) {
        const auto of = [&](double gain) { return static_cast<std::uint8_t>(level * gain + 0.5); };
        shared.push_back({{of(1), of(1), of(1)}, {of(0.5), of(1), of(1.25)}});
    }
    return shared;
}

TEST(ColorMatch, FindsAGainForEachChannel) {
    const auto match = color_match(greys_in_another_light());
    ASSERT_TRUE(match);
    EXPECT_EQ(match->own_from_other[0][50], 100);
    EXPECT_EQ(match->own_from_other[1][50], 50);
    EXPECT_EQ(match->own_from_other[2][50], 40);
    EXPECT_EQ(match->own_from_other[0][200], 255) << "no brighter than white";
    EXPECT_TRUE(match->is_same({100, 100, 100}, {50, 100, 125}));
    EXPECT_FALSE(match->is_same({100, 100, 100}, {100, 100, 100}));
}

TEST(ColorMatch, ToleratesWhatNineOfTenSurfacesKeep) {
    std::vector<SharedColor> shared;
    for (int i = 0; i < 200; ++i) {
        // Alternately, so that no gain explains it; but for one of twenty that moved.
        const int apart = i % 20 == 0 ? 90 : i % 2 == 0 ? 10 : -10;
        const auto level = static_cast<std::uint8_t>(120 + apart);
        shared.push_back({{120, 120, 120}, {level, level, level}});
    }
    const auto match = color_match(shared);
    ASSERT_TRUE(match);
    EXPECT_GE(match->tolerance, 8);
    EXPECT_LE(match->tolerance, 16);
}

TEST(ColorMatch, IsEmptyWherePhotographsShareTooLittle) {
    EXPECT_FALSE(color_match(std::vector<SharedColor>(49)));
    EXPECT_TRUE(color_match(std::vector<SharedColor>(50))) << "black is a colour";
}

TEST(ColorMatch, AveragesNineNeighbours) {
    ColorImage picture(5, 5);
    picture(2, 2) = {90, 180, 9};
    const ColorImage mean = averaged(picture);
    EXPECT_EQ(mean(1, 3), (Rgb8{10, 20, 1}));
    EXPECT_EQ(mean(0, 2), (Rgb8{0, 0, 0}));
}

}  // namespace
}  // namespace lumi
