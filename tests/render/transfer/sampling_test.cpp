#include "render/transfer/sampling.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

TEST(Bilinear, ReturnsTheTexelAtItsCentre) {
    FloatImage image(5, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x) image(x, y) = static_cast<float>(x * x + 10 * y);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x) EXPECT_EQ(bilinear(image, {x + 0.5, y + 0.5}), x * x + 10 * y);
}

TEST(Bilinear, IsExactForAnAffinePicture) {
    FloatImage image(5, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x) image(x, y) = static_cast<float>(2 * x - 3 * y);
    EXPECT_NEAR(bilinear(image, {2.25, 1.125}), 2 * 1.75 - 3 * 0.625, 1e-12);
}

TEST(Bilinear, ContinuesTheBorder) {
    const ColorImage image(3, 2, {10, 20, 30});
    EXPECT_EQ(bilinear(image, {-4, 9}), Eigen::Vector3d(10, 20, 30));
}

}  // namespace
}  // namespace lumi
