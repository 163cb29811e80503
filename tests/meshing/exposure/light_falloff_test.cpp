#include "meshing/exposure/light_falloff.h"

#include <gtest/gtest.h>

#include "calib/capture/light_left.h"
#include "meshing/exposure/exposure_gains.h"
#include "tests/meshing/exposure/exposed_wall.h"

namespace lumi {
namespace {

constexpr int kWallViews = 8;

double falloff_of(ExposedWall& wall) {
    const std::vector<PicturedView> views = wall.views();
    return light_falloff(views, shared_tiles(views, 1, SilentProgress()));
}

TEST(LightFalloff, IsFoundBesideExposuresAndHighlights) {
    for (const double falloff : {-0.3, -0.8, -2.0}) {
        ExposedWall wall(kWallViews);
        wall.add_highlights();
        for (int i = 0; i < kWallViews; ++i)
            wall.expose(i, Eigen::Array3d::Constant(i % 2 == 0 ? 0.7 : 0.95));
        wall.darken_corners(falloff);
        wall.add_noise(2.0);
        EXPECT_NEAR(falloff_of(wall), falloff, 0.04 * -falloff + 0.01);
    }
}

TEST(LightFalloff, IsNoneWhereNothingDarkensCorners) {
    ExposedWall plain(kWallViews);
    EXPECT_EQ(falloff_of(plain), 0.0);
    ExposedWall noisy(kWallViews);
    noisy.add_noise(4.0);
    noisy.add_highlights();
    for (const int view : {2, 5}) noisy.expose(view, Eigen::Array3d(0.5, 0.6, 0.5));
    EXPECT_EQ(falloff_of(noisy), 0.0);
}

// As much as surfaces that shine may seem to take.
TEST(LightFalloff, IsNoneWhereCornersLoseLittle) {
    ExposedWall wall(kWallViews);
    const Camera camera = wall.views().front().camera;
    const double falloff = -0.3 * 0.05 / (1 - light_left_in_corner(-0.3, camera));
    EXPECT_NEAR(light_left_in_corner(falloff, camera), 0.95, 0.005);
    wall.darken_corners(falloff);
    EXPECT_EQ(falloff_of(wall), 0.0);
}

TEST(LightFalloff, IsNoneWhereCornersAreBrighter) {
    ExposedWall wall(kWallViews);
    for (int i = 0; i < kWallViews; ++i) wall.expose(i, Eigen::Array3d::Constant(0.4));
    wall.darken_corners(0.8);
    EXPECT_EQ(falloff_of(wall), 0.0);
}

TEST(LightFalloff, IsNotTakenFromTwoOrThreePhotographsOnWhichLightFallsDifferently) {
    for (const int count : {2, 3}) {
        for (const double slope : {-0.1, 0.1}) {
            ExposedWall wall(count);
            for (int view = 0; view < count; ++view) wall.shade(view, slope * view);
            EXPECT_EQ(falloff_of(wall), 0.0) << count << " views, " << slope;
        }
    }
}

TEST(LightFalloff, IsNoneWhereNothingCanBeCompared) {
    ExposedWall one(1);
    EXPECT_EQ(falloff_of(one), 0.0);
    EXPECT_EQ(light_falloff({}, {}), 0.0);
}

TEST(LightFalloff, DoesNotPassForAnExposure) {
    ExposedWall wall(kWallViews);
    wall.darken_corners(-2.0);
    const std::vector<PicturedView> views = wall.views();
    const std::vector<SharedTiles> shared = shared_tiles(views, 1, SilentProgress());
    const ExposureGains left =
        exposure_gains(kWallViews, exposure_ratios(shared, light_falloff(views, shared)));
    EXPECT_EQ(left.model, ExposureModel::kNone);
    const ExposureGains taken_for = exposure_gains(kWallViews, exposure_ratios(shared, 0.0));
    EXPECT_GT(taken_for.difference_stops, 2 * left.difference_stops);
}

}  // namespace
}  // namespace lumi
