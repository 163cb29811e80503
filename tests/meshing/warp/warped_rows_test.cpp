#include "meshing/warp/warped_rows.h"

#include <gtest/gtest.h>

#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

TEST(WarpedRows, FallWhereEachPixelFallsByItself) {
    const Camera camera = small_camera();
    Rigid3 turned = looking_ahead_from({0.4, -0.1, 0.3});
    turned.rotation = Eigen::AngleAxisd(0.1, Eigen::Vector3d(0.2, 1, 0.3).normalized());
    const InverseDepthWarp warp =
        warp_from({camera, looking_ahead_from({0, 0, 0})}).to({camera, turned});
    DepthMap map{FloatImage(240, 180), GrayImage(240, 180)};
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 240; ++x) {
            map.inverse_depth(x, y) = 0.1F + 0.001F * static_cast<float>((37 * x + 11 * y) % 400);
            map.confidence(x, y) = (x + y) % 3 == 0 ? 0 : 255;
        }
    }
    const WarpRaster raster{300, 200, 30, 10};
    int fallen = 0;
    int apart = 0;
    int next = 0;
    warp_rows(map, warp, raster, 3, [&](int y, const WarpedRow& row) {
        ASSERT_EQ(y, next);
        next += 3;
        ASSERT_EQ(row.rows.size(), 240U);
        for (int x = 0; x < 240; ++x) {
            const auto i = static_cast<std::size_t>(x);
            const double inverse_depth = static_cast<double>(map.inverse_depth(x, y));
            const Eigen::Vector3d there = warp.homogeneous_at({x + 0.5, y + 0.5}, inverse_depth);
            const double column = there.x() / there.z() + 30;
            const double at_row = there.y() / there.z() + 10;
            const bool is_in = map.confidence(x, y) != 0 && there.z() > 0 && column >= 0 &&
                               column < 300 && at_row >= 0 && at_row < 200;
            if ((row.rows[i] >= 0) != is_in) ++apart;
            if (!is_in || row.rows[i] < 0) continue;
            ++fallen;
            EXPECT_NEAR(row.inverse_depths[i], inverse_depth / there.z(), 1e-5);
            EXPECT_NEAR(row.columns[i] + 0.5, column, 0.501);
            EXPECT_NEAR(row.rows[i] + 0.5, at_row, 0.501);
        }
    });
    EXPECT_GT(fallen, 5000);
    EXPECT_LE(apart, 3) << "rounding at the border";
}

}  // namespace
}  // namespace lumi
