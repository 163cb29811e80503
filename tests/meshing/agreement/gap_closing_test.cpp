#include "meshing/agreement/gap_closing.h"

#include <gtest/gtest.h>

#include <utility>

namespace lumi {
namespace {

TEST(GapClosing, GivesAGapTheMedianAroundItAndLeavesLonePixelsOut) {
    DepthMap map{FloatImage(20, 10), GrayImage(20, 10)};
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 8; ++x) {
            map.inverse_depth(x, y) = static_cast<float>(x);
            map.confidence(x, y) = 255;
        }
    }
    map.confidence(4, 5) = 0;
    map.inverse_depth(4, 5) = 50.0F;   // What it holds is nothing.
    map.inverse_depth(6, 3) = 100.0F;  // One wrong pixel.
    map.confidence(2, 5) = 0;          // Among pixels that one view alone confirms.
    map.inverse_depth(2, 5) = 50.0F;
    for (int y = 4; y < 7; ++y) {
        for (int x = 1; x < 4; ++x) map.confidence(x, y) = map.confidence(x, y) == 0 ? 0 : 128;
    }
    map.inverse_depth(15, 5) = 7.0F;
    map.confidence(15, 5) = 255;
    const DepthMap closed = with_gaps_closed(map);
    EXPECT_EQ(closed.confidence(4, 5), 255);
    EXPECT_NEAR(closed.inverse_depth(4, 5), 4.0F, 1.0F);
    EXPECT_EQ(closed.confidence(2, 5), 255);
    EXPECT_EQ(closed.inverse_depth(2, 5), 2.0F);
    EXPECT_NEAR(closed.inverse_depth(6, 3), 6.0F, 1.0F);
    EXPECT_EQ(closed.confidence(15, 5), 0);
    EXPECT_EQ(closed.confidence(12, 5), 0) << "wider gaps stay";
}

TEST(GapClosing, AsksKnownPixelsAlone) {
    DepthMap map{FloatImage(10, 10, 2.0F), GrayImage(10, 10, 255)};
    for (const auto& [x, y] :
         {std::pair(4, 4), std::pair(4, 5), std::pair(5, 4), std::pair(5, 5), std::pair(5, 6)}) {
        map.confidence(x, y) = 0;
        map.inverse_depth(x, y) = 50.0F;
    }
    const DepthMap closed = with_gaps_closed(map);
    EXPECT_EQ(closed.inverse_depth(4, 5), 2.0F) << "five of nine pixels around it are unknown";
    EXPECT_EQ(closed.confidence(4, 5), 255);
}

}  // namespace
}  // namespace lumi
