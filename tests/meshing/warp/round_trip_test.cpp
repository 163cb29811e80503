#include "meshing/warp/round_trip.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lumi {
namespace {

constexpr double kFocalPx = 200;
constexpr double kBaseline = 0.5;
const Camera kCamera = pinhole_camera(320, 240, kFocalPx);
const Rigid3 kHere;
const Rigid3 kBeside{Eigen::Quaterniond::Identity(), {-kBaseline, 0, 0}};
const Eigen::Vector2d kPixel(150, 100);

TEST(RoundTrip, ComesBackToWhereItSetOutWhereBothSeeOneSurface) {
    const RoundTrip trip = round_trip({kCamera, kHere}, {kCamera, kBeside});
    const auto there = trip.there.at(kPixel, 0.25);
    ASSERT_TRUE(there.has_value());
    const auto returned = trip.returned(kPixel, there->pixel, there->inverse_depth);
    ASSERT_TRUE(returned.has_value());
    EXPECT_NEAR(returned->error_px, 0, 1e-12);
    EXPECT_NEAR(returned->inverse_depth, 0.25, 1e-12);
}

// Cameras side by side: the disparity is the focal length times the baseline times the inverse
// depth, there and back.
TEST(RoundTrip, IsWrongByTheDifferenceOfDisparities) {
    const RoundTrip trip = round_trip({kCamera, kHere}, {kCamera, kBeside});
    for (const double found : {0.1, 0.24, 0.26, 0.9}) {
        const auto there = trip.there.at(kPixel, 0.25);
        ASSERT_TRUE(there.has_value());
        const auto returned = trip.returned(kPixel, there->pixel, found);
        ASSERT_TRUE(returned.has_value());
        EXPECT_NEAR(returned->error_px, kFocalPx * kBaseline * std::abs(found - 0.25), 1e-10);
        EXPECT_NEAR(returned->inverse_depth, found, 1e-12);
    }
}

TEST(RoundTrip, DoesNotComeBackFromBehindTheView) {
    const Rigid3 two_behind{Eigen::Quaterniond::Identity(), {0, 0, 2}};
    const RoundTrip trip = round_trip({kCamera, kHere}, {kCamera, two_behind});
    const auto there = trip.there.at(kPixel, 0.25);
    ASSERT_TRUE(there.has_value());
    EXPECT_FALSE(trip.returned(kPixel, there->pixel, 1 / 1.9).has_value());
    EXPECT_TRUE(trip.returned(kPixel, there->pixel, 1 / 2.1).has_value());
}

}  // namespace
}  // namespace lumi
