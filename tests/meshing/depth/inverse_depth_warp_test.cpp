#include "meshing/warp/inverse_depth_warp.h"

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

TEST(InverseDepthWarp, SendsAPixelWhereItsPointIsSeen) {
    const InverseDepthWarp warp = warp_b_from_a(kLeft, kLeftFromWorld, kRight, kRightFromWorld);
    for (const double depth : {0.8, 3.0, 50.0}) {
        for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(10, 20), Eigen::Vector2d(600, 300)}) {
            const Eigen::Vector3d in_left = depth * unproject(kLeft, pixel);
            const Eigen::Vector3d in_right = kRightFromWorld * (inverse(kLeftFromWorld) * in_left);
            const Eigen::Vector3d warped = warp(pixel, 1 / depth);
            EXPECT_LT((warped.hnormalized() - *project(kRight, in_right)).norm(), 1e-9);
            EXPECT_NEAR(1 / depth / warped.z(), 1 / in_right.z(), 1e-12);
        }
    }
}

TEST(InverseDepthWarp, DisparityIsTheDerivativeOfThePixel) {
    const InverseDepthWarp warp = warp_b_from_a(kLeft, kLeftFromWorld, kRight, kRightFromWorld);
    const Eigen::Vector2d pixel(200, 100);
    constexpr double kStep = 1e-6;
    const Eigen::Vector2d moved =
        warp(pixel, 0.5 + kStep).hnormalized() - warp(pixel, 0.5 - kStep).hnormalized();
    EXPECT_NEAR(disparity_per_inverse_depth(warp, pixel, 0.5), moved.norm() / (2 * kStep), 1e-4);
}

TEST(InverseDepthWarp, ComparesWithACameraAheadWhereThingsAreTwiceAsLargeAtMost) {
    const Rigid3 three_ahead{Eigen::Quaterniond::Identity(), {0, 0, -3}};
    const InverseDepthWarp warp = warp_b_from_a(kLeft, {}, kLeft, three_ahead);
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

TEST(InverseDepthWarp, ComparesWithACameraBesideOrBehindAsNearAsAsked) {
    for (const Eigen::Vector3d& step :
         {Eigen::Vector3d(0.5, 0, 0), Eigen::Vector3d(0, 0.2, 0), Eigen::Vector3d(0, 0, 3)}) {
        const InverseDepthWarp warp =
            warp_b_from_a(kLeft, {}, kLeft, {Eigen::Quaterniond::Identity(), step});
        EXPECT_EQ(comparable_inverse_depth(warp, {200, 100}, 1 / 0.8), 1 / 0.8);
    }
}

}  // namespace
}  // namespace lumi
