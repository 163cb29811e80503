#include "calib/pictures/inpainting.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

TEST(Inpainting, ContinuesAPlainPictureOverTheHoleAndChangesNothingElse) {
    ColorImage picture(40, 30, {90, 120, 150});
    picture(2, 3) = {1, 2, 3};
    GrayImage mask(40, 30, 255);
    for (int y = 12; y < 18; ++y) {
        for (int x = 15; x < 25; ++x) {
            mask(x, y) = 0;
            picture(x, y) = {255, 0, 0};
        }
    }
    const ColorImage before = picture;
    paint_from_rim(mask, picture);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            if (mask(x, y) != 0) {
                EXPECT_EQ(picture(x, y), before(x, y)) << x << ", " << y;
                continue;
            }
            EXPECT_NEAR(picture(x, y).r, 90, 3) << x << ", " << y;
            EXPECT_NEAR(picture(x, y).g, 120, 3) << x << ", " << y;
            EXPECT_NEAR(picture(x, y).b, 150, 3) << x << ", " << y;
        }
    }
}

}  // namespace
}  // namespace lumi
