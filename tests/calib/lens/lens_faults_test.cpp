#include "calib/lens/lens_faults.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

Camera rational(double k1, double k2, double k3, double k4, double k5, double k6) {
    // In the order of OpenCV: k1 k2 p1 p2 k3 k4 k5 k6.
    return {1000, 750, LensModel::kFullOpenCv, {800, 800, 500, 375, k1, k2, 0, 0, k3, k4, k5, k6}};
}

TEST(LensFault, NothingSpeaksAgainstAnOrdinaryLens) {
    EXPECT_EQ(lens_fault(pinhole_camera(640, 480, 500), 0.8), "");
    EXPECT_EQ(lens_fault({640, 480, LensModel::kRadial, {500, 320, 240, -0.25, 0.1}}, 0.8), "");
    EXPECT_EQ(lens_fault(rational(0.3, 0.1, 0.01, 0.5, 0.2, 0.02), 0.8), "");
    EXPECT_EQ(
        lens_fault({640, 480, LensModel::kOpenCvFisheye, {190, 190, 320, 240, 0.01, 0, 0, 0}}, 1.5),
        "");
}

TEST(LensFault, ADistortionThatTurnsBackFoldsThePicture) {
    // r (1 - 0.5 r^2) grows up to r = 0.816, where it is 0.544.
    const Camera lens{640, 480, LensModel::kSimpleRadial, {500, 320, 240, -0.5}};
    EXPECT_EQ(lens_fault(lens, 0.54), "");
    EXPECT_EQ(lens_fault(lens, 0.55), "folds over within the picture");
}

TEST(LensFault, APoleWithinThePictureThatAZeroCancelsIsNoLens) {
    const char* const kCancelled = "a pole and a zero of its distortion cancel";
    EXPECT_EQ(lens_fault(rational(412, 9.3, 0, 400, 0, 0), 0.8), kCancelled);
    // (1 + 2 u) (1 - u / 5) over (1 + 2.05 u) (1 - u / 5.5), u = r^2: the pole lies at |r| = 0.7.
    const Camera lens = rational(1.8, -0.4, 0, 2.05 - 1 / 5.5, -2.05 / 5.5, 0);
    EXPECT_EQ(lens_fault(lens, 0.75), kCancelled);
    EXPECT_EQ(lens_fault(lens, 0.65), "");
}

}  // namespace
}  // namespace lumi
