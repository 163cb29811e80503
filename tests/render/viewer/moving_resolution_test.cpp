#include "render/viewer/moving_resolution.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lumi {
namespace {

TEST(MovingResolution, StaysWholeWhereDrawingIsQuick) {
    MovingResolution resolution;
    EXPECT_EQ(resolution.scale_while_moving(), 1.0);
    for (int i = 0; i < 10; ++i) resolution.measured(1.0, 20.0);
    EXPECT_EQ(resolution.scale_while_moving(), 1.0);
}

TEST(MovingResolution, KeepsTheTargetWhereDrawingIsSlow) {
    MovingResolution resolution;
    double scale = 1.0;
    for (int i = 0; i < 30; ++i) {
        resolution.measured(scale, 120.0 * scale * scale);
        scale = resolution.scale_while_moving();
    }
    EXPECT_EQ(scale, 0.5) << "120 ms, a quarter of it is 30";
}

TEST(MovingResolution, IsCoarserWhereMoreFramesASecondAreWanted) {
    MovingResolution sixty(60.0);
    MovingResolution by_itself;
    for (MovingResolution* resolution : {&sixty, &by_itself}) resolution->measured(1.0, 25.0);
    EXPECT_EQ(by_itself.scale_while_moving(), 1.0);
    EXPECT_EQ(sixty.scale_while_moving(), std::sqrt(0.5));
}

TEST(MovingResolution, ComesToTheFinestThatKeepsTheTargetThoughMuchDoesNotGrowWithPixels) {
    const auto frame_ms = [](double scale) { return 10 + 95 * scale * scale; };
    MovingResolution resolution;
    resolution.measured(1.0, 300.0);  // The first frame of all.
    double scale = 0;
    for (int i = 0; i < 60; ++i) {
        scale = resolution.scale_while_moving();
        resolution.measured(scale, frame_ms(scale));
    }
    EXPECT_EQ(scale, std::exp2(-1.5)) << "22 ms; twice the pixels take 34, more than 33";
    EXPECT_GT(frame_ms(std::sqrt(2.0) * scale), 1000 / MovingResolution::kFramesPerSecond);
}

TEST(MovingResolution, BelievesAFrameAtRestOnlyUntilOneOfAMovingEyeIsMeasured) {
    MovingResolution resolution;
    resolution.guessed(1.0, 290.0);
    EXPECT_LT(resolution.scale_while_moving(), 0.5);
    resolution.measured(0.5, 15.0);  // Smooth silhouettes are what took so long.
    EXPECT_EQ(resolution.scale_while_moving(), std::sqrt(0.5));
    resolution.guessed(1.0, 290.0);
    EXPECT_EQ(resolution.scale_while_moving(), std::sqrt(0.5));
}

TEST(MovingResolution, FramesOfAnotherKindBeginWithAGuess) {
    MovingResolution resolution;
    for (int i = 0; i < 10; ++i) resolution.measured(1.0, 120.0);
    resolution.begin_anew();
    EXPECT_EQ(resolution.scale_while_moving(), 0.5);
    resolution.measured(0.5, 5.0);
    EXPECT_EQ(resolution.scale_while_moving(), 1.0);
}

TEST(MovingResolution, GoesNoCoarserThanItsLimitAndRecovers) {
    MovingResolution resolution;
    for (int i = 0; i < 10; ++i) resolution.measured(1.0, 1e6);
    EXPECT_EQ(resolution.scale_while_moving(), MovingResolution::kCoarsest);
    for (int i = 0; i < 60; ++i) resolution.measured(MovingResolution::kCoarsest, 0.1);
    EXPECT_EQ(resolution.scale_while_moving(), 1.0);
}

}  // namespace
}  // namespace lumi
