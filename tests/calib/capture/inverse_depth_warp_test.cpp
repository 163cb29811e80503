#include "calib/capture/inverse_depth_warp.h"

#include <gtest/gtest.h>

#include <random>

#include "calib/capture/calibration_matrix.h"

namespace lumi {
namespace {

/// What a view, an eye and whatever else has a camera somewhere have in common.
struct Standing {
    Camera camera;
    Rigid3 cam_from_world;
};

const Standing kLeft{
    Camera{640, 480, LensModel::kPinhole, {500, 540, 310, 250}},
    {Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY())), {0.3, -0.1, 0.4}}};
const Standing kRight{
    Camera{800, 600, LensModel::kPinhole, {700, 710, 390, 310}},
    {Eigen::Quaterniond(Eigen::AngleAxisd(-0.3, Eigen::Vector3d(1, 2, 0.5).normalized())),
     {-0.5, 0.2, 0.6}}};

Eigen::Vector3d in_right_of(const Eigen::Vector3d& in_left) {
    return kRight.cam_from_world * (inverse(kLeft.cam_from_world) * in_left);
}

class SeenPixels {
 public:
    SeenPixels() : x_(0, 640), y_(0, 480), inverse_depth_(0.02, 1.05) {}

    Eigen::Vector2d next_pixel() { return {x_(random_), y_(random_)}; }
    double next_inverse_depth() { return inverse_depth_(random_); }

 private:
    std::mt19937 random_{1};
    std::uniform_real_distribution<double> x_;
    std::uniform_real_distribution<double> y_;
    std::uniform_real_distribution<double> inverse_depth_;
};

TEST(CalibrationMatrix, ProjectsAsTheCameraDoes) {
    for (const Eigen::Vector3d& point :
         {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.3, -0.2, 1), Eigen::Vector3d(-2, 1, 7)}) {
        const Eigen::Vector2d pixel = (calibration_matrix(kRight.camera) * point).hnormalized();
        EXPECT_LT((pixel - *project(kRight.camera, point)).norm(), 1e-10);
    }
}

TEST(InverseDepthWarp, SendsAPixelWhereItsPointIsSeen) {
    const InverseDepthWarp right_from_left = warp_from(kLeft).to(kRight);
    SeenPixels seen;
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector2d pixel = seen.next_pixel();
        const double inverse_depth = seen.next_inverse_depth();
        const Eigen::Vector3d in_right =
            in_right_of(unproject(kLeft.camera, pixel) / inverse_depth);
        const Eigen::Vector3d place = right_from_left.homogeneous_at(pixel, inverse_depth);
        ASSERT_GT(in_right.z(), 0);
        const Eigen::Vector2d expected = *project(kRight.camera, in_right);
        EXPECT_LT((place.hnormalized() - expected).norm(), 1e-9);
        EXPECT_NEAR(place.z(), in_right.z() * inverse_depth, 1e-12);
        const auto at = right_from_left.at(pixel, inverse_depth);
        ASSERT_TRUE(at.has_value());
        EXPECT_LT((at->pixel - expected).norm(), 1e-9);
        EXPECT_NEAR(at->inverse_depth, 1 / in_right.z(), 1e-12);
    }
}

TEST(InverseDepthWarp, SendsADirectionToWhereItVanishes) {
    const InverseDepthWarp right_from_left = warp_from(kLeft).to(kRight);
    const Eigen::Vector2d pixel(200, 100);
    const Rigid3 b_from_a = kRight.cam_from_world * inverse(kLeft.cam_from_world);
    const Eigen::Vector3d direction = b_from_a.rotation * unproject(kLeft.camera, pixel);
    const auto at = right_from_left.at(pixel, 0);
    ASSERT_TRUE(at.has_value());
    EXPECT_LT((at->pixel - *project(kRight.camera, direction)).norm(), 1e-9);
    EXPECT_EQ(at->inverse_depth, 0);
}

TEST(InverseDepthWarp, GoesThereAndBack) {
    const InverseDepthWarp right_from_left = warp_from(kLeft).to(kRight);
    const InverseDepthWarp left_from_right = warp_from(kRight).to(kLeft);
    SeenPixels seen;
    for (int i = 0; i < 50; ++i) {
        const Eigen::Vector2d pixel = seen.next_pixel();
        const double inverse_depth = seen.next_inverse_depth();
        const auto there = right_from_left.at(pixel, inverse_depth);
        ASSERT_TRUE(there.has_value());
        const auto back = left_from_right.at(there->pixel, there->inverse_depth);
        ASSERT_TRUE(back.has_value());
        EXPECT_LT((back->pixel - pixel).norm(), 1e-8);
        EXPECT_NEAR(back->inverse_depth, inverse_depth, 1e-12);
    }
}

TEST(InverseDepthWarp, HasNoPixelForWhatIsBehindTheOther) {
    const Standing here{pinhole_camera(640, 480, 500), {}};
    const Standing three_ahead{here.camera, {Eigen::Quaterniond::Identity(), {0, 0, -3}}};
    const InverseDepthWarp ahead_from_here = warp_from(here).to(three_ahead);
    for (const double depth : {1.0, 2.9, 3.0})
        EXPECT_FALSE(ahead_from_here.at({200, 100}, 1 / depth).has_value()) << depth;
    const auto before = ahead_from_here.at({200, 100}, 1 / 4.0);
    ASSERT_TRUE(before.has_value());
    EXPECT_NEAR(before->inverse_depth, 1, 1e-12);
    EXPECT_LT((before->pixel - Eigen::Vector2d(-160, -320)).norm(), 1e-9);
}

TEST(InverseDepthWarp, IsAHomographyForThePointsOfAPlane) {
    const InverseDepthWarp right_from_left = warp_from(kLeft).to(kRight);
    const Eigen::Vector3d plane_inverse_depth(1e-4, -2e-4, 0.3);
    const Eigen::Matrix3d homography = right_from_left.homography_of(plane_inverse_depth);
    SeenPixels seen;
    for (int i = 0; i < 50; ++i) {
        const Eigen::Vector2d pixel = seen.next_pixel();
        const Eigen::Vector3d expected =
            right_from_left.homogeneous_at(pixel, plane_inverse_depth.dot(pixel.homogeneous()));
        EXPECT_LT((homography * pixel.homogeneous() - expected).norm(), 1e-9);
    }
}

}  // namespace
}  // namespace lumi
