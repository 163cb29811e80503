#include "meshing/warp/disparity.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

const Camera kLeft = pinhole_camera(640, 480, 500);
const Camera kRight{800, 600, LensModel::kPinhole, {700, 710, 390, 310}};
const Rigid3 kLeftFromWorld{Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY())),
                            {0.3, -0.1, 0.4}};
const Rigid3 kRightFromWorld{
    Eigen::Quaterniond(Eigen::AngleAxisd(-0.3, Eigen::Vector3d(1, 2, 0.5).normalized())),
    {-0.5, 0.2, 0.6}};

TEST(Disparity, IsTheDerivativeOfThePixel) {
    const InverseDepthWarp warp = warp_from({kLeft, kLeftFromWorld}).to({kRight, kRightFromWorld});
    const Eigen::Vector2d pixel(200, 100);
    constexpr double kStep = 1e-6;
    const Eigen::Vector2d moved = warp.homogeneous_at(pixel, 0.5 + kStep).hnormalized() -
                                  warp.homogeneous_at(pixel, 0.5 - kStep).hnormalized();
    EXPECT_NEAR(disparity_per_inverse_depth(warp, pixel, 0.5), moved.norm() / (2 * kStep), 1e-4);
}

TEST(ComparableInverseDepth, ComparesWithACameraAheadWhereThingsAreTwiceAsLargeAtMost) {
    const Rigid3 three_ahead{Eigen::Quaterniond::Identity(), {0, 0, -3}};
    const InverseDepthWarp warp = warp_from({kLeft, Rigid3{}}).to({kLeft, three_ahead});
    const Eigen::Vector2d pixel(200, 100);
    // Passed, about to be passed, and far enough: 6 ahead of the one is 3 ahead of the other.
    EXPECT_NEAR(comparable_inverse_depth(warp, pixel, 1 / 2.5), 1 / 6.0, 1e-12);
    EXPECT_NEAR(comparable_inverse_depth(warp, pixel, 1 / 3.001), 1 / 6.0, 1e-12);
    EXPECT_EQ(comparable_inverse_depth(warp, pixel, 1 / 7.0), 1 / 7.0);
    // By the derivative of r / (1 - 3 q): four times the length of the step and the distance from
    // where both look.
    EXPECT_NEAR(disparity_per_inverse_depth(warp, pixel, 1 / 6.0),
                4 * 3 * (pixel - Eigen::Vector2d(320, 240)).norm(), 1e-6);
}

TEST(ComparableInverseDepth, ComparesWithACameraBesideOrBehindAsNearAsAsked) {
    for (const Eigen::Vector3d& step :
         {Eigen::Vector3d(0.5, 0, 0), Eigen::Vector3d(0, 0.2, 0), Eigen::Vector3d(0, 0, 3)}) {
        const InverseDepthWarp warp =
            warp_from({kLeft, Rigid3{}}).to({kLeft, Rigid3{Eigen::Quaterniond::Identity(), step}});
        EXPECT_EQ(comparable_inverse_depth(warp, {200, 100}, 1 / 0.8), 1 / 0.8);
    }
}

}  // namespace
}  // namespace lumi
