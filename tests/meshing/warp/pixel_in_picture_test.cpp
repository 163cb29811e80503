#include "meshing/warp/pixel_in_picture.h"

#include <gtest/gtest.h>

#include <limits>

namespace lumi {
namespace {

std::optional<WarpedPixel> seen_at(const Eigen::Vector3d& homogeneous) {
    return WarpedPixel::of(homogeneous, 1);
}

TEST(PixelInPicture, IsWhereAPlaceFallsAndNoneOutsideOrBehind) {
    EXPECT_EQ(pixel_in_picture(seen_at({0, 0, 1}), 40, 30), Eigen::Vector2i(0, 0));
    EXPECT_EQ(pixel_in_picture(seen_at({79.8, 59.8, 2}), 40, 30), Eigen::Vector2i(39, 29));
    for (const Eigen::Vector3d& outside : {Eigen::Vector3d(-0.1, 5, 1), Eigen::Vector3d(5, -0.1, 1),
                                           Eigen::Vector3d(40, 5, 1), Eigen::Vector3d(5, 30, 1)}) {
        EXPECT_FALSE(pixel_in_picture(seen_at(outside), 40, 30).has_value()) << outside.transpose();
    }
    EXPECT_FALSE(pixel_in_picture(seen_at({5, 5, 0}), 40, 30).has_value());
    EXPECT_FALSE(pixel_in_picture(seen_at({-5, -5, -1}), 40, 30).has_value());
    EXPECT_FALSE(pixel_in_picture(seen_at({0, 0, 1}), 0, 0).has_value());
}

TEST(PixelInPicture, IsNoneWhereNoIntegerCountsPixels) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(1, 1, 1e-12), Eigen::Vector3d(1, -1, 1e-300),
          Eigen::Vector3d(1e300, 1, 1e-300), Eigen::Vector3d(kNan, 1, 1),
          Eigen::Vector3d(1, kNan, 1), Eigen::Vector3d(1, 1, kNan)}) {
        EXPECT_FALSE(pixel_in_picture(seen_at(place), 40, 30).has_value()) << place.transpose();
    }
}

}  // namespace
}  // namespace lumi
