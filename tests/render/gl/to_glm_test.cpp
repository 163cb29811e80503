#include "render/gl/to_glm.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace lumi {
namespace {

constexpr int kPictureWidth_px = 320;
constexpr int kPictureHeight_px = 200;

/// Where GL puts a pixel at an inverse depth, given with any W: -1 to 1, upwards, near to far.
Eigen::Vector3d in_clip_space(const Eigen::Vector2d& pixel, double inverse_depth, double w) {
    const double max_inverse_depth = 0.5;
    const Eigen::Vector4d clip =
        clip_from_pixel(kPictureWidth_px, kPictureHeight_px, max_inverse_depth) *
        Eigen::Vector4d(pixel.x() * w, pixel.y() * w, w, inverse_depth * w);
    return clip.hnormalized();
}

TEST(ToGlm, ThePictureFillsTheWindowFromTheTop) {
    for (const double w : {1.0, 7.0}) {
        EXPECT_TRUE(in_clip_space({0, 0}, 0.2, w).head<2>().isApprox(Eigen::Vector2d(-1, 1)));
        EXPECT_TRUE(in_clip_space({320, 200}, 0.2, w).head<2>().isApprox(Eigen::Vector2d(1, -1)));
        EXPECT_TRUE(in_clip_space({160, 50}, 0.2, w).head<2>().isApprox(Eigen::Vector2d(0, 0.5)));
    }
}

TEST(ToGlm, DepthIsAffineInInverseDepthFromTheNearestToInfinity) {
    for (const double w : {1.0, 7.0}) {
        EXPECT_NEAR(in_clip_space({30, 40}, 0.5, w).z(), -1, 1e-12);
        EXPECT_NEAR(in_clip_space({30, 40}, 0.25, w).z(), 0, 1e-12);
        EXPECT_NEAR(in_clip_space({30, 40}, 0.125, w).z(), 0.5, 1e-12);
        EXPECT_NEAR(in_clip_space({30, 40}, 0.0, w).z(), 1, 1e-12);
    }
}

TEST(ToGlm, AWindowsPlaceIsThePixelThatClipSpacePutsThere) {
    const Eigen::Vector2d pixel(12.5, 30.25);
    const Eigen::Vector2d in_clip = in_clip_space(pixel, 0.1, 1).head<2>();
    const Eigen::Vector3d in_window(0.5 * (in_clip.x() + 1) * kPictureWidth_px,
                                    0.5 * (in_clip.y() + 1) * kPictureHeight_px, 1);
    EXPECT_TRUE((pixel_from_window(kPictureHeight_px) * in_window).hnormalized().isApprox(pixel));
}

TEST(ToGlm, ARowOfTheFramebufferIsThatOfItsPixels) {
    for (const int y : {0, 57, kPictureHeight_px - 1}) {
        const Eigen::Vector3d in_window(3.5, framebuffer_row(y, kPictureHeight_px) + 0.5, 1);
        EXPECT_EQ((pixel_from_window(kPictureHeight_px) * in_window).y(), y + 0.5);
    }
}

TEST(ToGlm, KeepsRowsAndColumns) {
    Eigen::Matrix4d matrix;
    matrix << 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15;
    const glm::mat4 same = to_glm(matrix);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            EXPECT_EQ(same[column][row], static_cast<float>(4 * row + column));
}

}  // namespace
}  // namespace lumi
