#include "meshing/cameras/forward_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "calib/capture/degrees.h"

namespace lumi {
namespace {

/// Cameras on the z axis that sway beside it by `sway`, all looking `angle_deg` past it.
std::vector<OpticalAxis> walk(int count, double step, double sway, double angle_deg) {
    const double angle = angle_deg * kRadiansPerDegree;
    std::vector<OpticalAxis> axes;
    for (int i = 0; i < count; ++i) {
        OpticalAxis axis;
        axis.view_index = i;
        axis.centre_in_world = {sway * std::cos(1.7 * i), sway * std::sin(1.7 * i), step * i};
        axis.direction_in_world = {std::sin(angle), 0, std::cos(angle)};
        axes.push_back(axis);
    }
    return axes;
}

TEST(ForwardMotion, IsFoundUpToAFifthOfSwayAndThirtyDegrees) {
    // 0.1 beside a way of 9 steps of 0.3: sigmas of 0.07 and 0.86.
    const auto straight = forward_motion(walk(10, 0.3, 0.1, 0));
    ASSERT_TRUE(straight.has_value());
    EXPECT_NEAR(straight->sway_share, 0.082, 0.02);
    EXPECT_LT(straight->angle_deg, 5);
    EXPECT_TRUE(forward_motion(walk(10, 0.3, 0.1, 25)).has_value());
    EXPECT_FALSE(forward_motion(walk(10, 0.3, 0.1, 36)).has_value());
    EXPECT_FALSE(forward_motion(walk(10, 0.3, 0.5, 0)).has_value());
}

TEST(ForwardMotion, IsWalkedBackwardsToo) {
    EXPECT_TRUE(forward_motion(walk(10, -0.3, 0.1, 0)).has_value());
}

TEST(ForwardMotion, IsNoneOfOneCameraOrOfCamerasThatLookAllAround) {
    EXPECT_FALSE(forward_motion(walk(1, 1, 0, 0)).has_value());
    EXPECT_FALSE(forward_motion(walk(4, 0, 0, 0)).has_value());
    std::vector<OpticalAxis> looking_around = walk(8, 0.3, 0, 0);
    for (int i = 0; i < 8; ++i)
        looking_around[static_cast<std::size_t>(i)].direction_in_world = {std::sin(0.8 * i), 0,
                                                                          std::cos(0.8 * i)};
    EXPECT_FALSE(forward_motion(looking_around).has_value());
}

}  // namespace
}  // namespace lumi
