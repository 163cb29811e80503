#include "render/rivals/rival_methods.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/rivals/spherical_light_field.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const ResampledRival& rival_named(const std::string& name) {
    const auto& rivals = resampled_rivals();
    return *std::find_if(rivals.begin(), rivals.end(),
                         [&](const ResampledRival& rival) { return rival.name == name; });
}

TEST(RivalMethods, InPlainCodeNeedDepthOfEveryPhotographWhereTheyDrawFromIt) {
    Lumigraph lumigraph = card_before_wall();
    for (const PlainRival& rival : plain_rivals())
        EXPECT_THAT(rival.reason_against(lumigraph), IsEmpty()) << rival.name;
    lumigraph.views[3].depth = {};
    for (const PlainRival& rival : plain_rivals()) {
        if (rival.draws_from_depth) {
            EXPECT_THAT(rival.reason_against(lumigraph), HasSubstr("1 of 9 photographs"))
                << rival.name;
        } else {
            EXPECT_THAT(rival.reason_against(lumigraph), IsEmpty()) << rival.name;
        }
    }
}

TEST(RivalMethods, TwoPlaneIsOneSlabBeforeAWallAndSixAroundABall) {
    const ResampledRival& two_plane = rival_named("two-plane");
    const Lumigraph wall = card_before_wall();
    EXPECT_THAT(two_plane.reason_against(wall), IsEmpty());
    EXPECT_EQ(two_plane.layout(wall).eyes.size(), 9U) << "as many as photographs";
    const Lumigraph ball = ball_in_sky();
    EXPECT_THAT(two_plane.reason_against(ball), IsEmpty());
    EXPECT_EQ(two_plane.layout(ball).eyes.size(), 6U * 4U) << "the least grid on each side";
}

/// A ring of sixteen cameras so high above the ball, which look at it. Down is +y.
Lumigraph ring_above_ball(double elevation_deg) {
    const double elevation = elevation_deg * std::numbers::pi / 180;
    std::vector<Eye> cameras;
    for (int i = 0; i < 16; ++i) {
        const double azimuth = 2 * std::numbers::pi * i / 16 + 0.1;
        cameras.push_back(eye_at(
            4 * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth), -std::sin(elevation),
                                std::cos(elevation) * std::sin(azimuth)),
            {0, 0, 0}, pinhole_camera(64, 48, 60)));
    }
    Lumigraph ring = photographed(AnalyticScene::kBallInSky, cameras);
    ring.mesh.construction = MeshConstruction::kClosed;
    return ring;
}

TEST(RivalMethods, CamerasAllAroundThatLookDownALittleAreAllAround) {
    for (const double elevation_deg : {0.5, 10.0, 25.0}) {
        const Lumigraph ring = ring_above_ball(elevation_deg);
        EXPECT_EQ(rival_named("two-plane").layout(ring).eyes.size(), 6U * 4U) << elevation_deg;
        EXPECT_THAT(rival_named("spherical").reason_against(ring), IsEmpty()) << elevation_deg;
    }
}

TEST(RivalMethods, ASlabBelowCamerasAllAroundItsAxisStandsAsTheFirstPhotograph) {
    const Lumigraph ring = ring_above_ball(50);
    const Eigen::Vector3d first_down =
        ring.views[0].cam_from_world.rotation.conjugate() * Eigen::Vector3d::UnitY();
    const LightFieldLayout slab = rival_named("two-plane").layout(ring);
    ASSERT_EQ(slab.eyes.size(), 16U);
    for (const Eye& eye : slab.eyes) {
        EXPECT_NEAR(optical_axis_in_world(eye.cam_from_world).y(), 1, 1e-9);
        EXPECT_NEAR((eye.cam_from_world.rotation * first_down).x(), 0, 1e-9);
        EXPECT_GT((eye.cam_from_world.rotation * first_down).y(), 0);
    }
}

TEST(RivalMethods, PicturesOfASlabAreLikeThePhotographsAndOthersSquareWithTheirPixels) {
    for (const Eye& eye : rival_named("two-plane").layout(card_before_wall()).eyes) {
        EXPECT_EQ(eye.camera.width_px, 64);
        EXPECT_EQ(eye.camera.height_px, 48);
    }
    const Lumigraph ball = ball_in_sky();
    const Camera& photograph = ball.views[0].camera;
    const double side_px =
        std::sqrt(static_cast<double>(photograph.width_px) * photograph.height_px);
    for (const char* name : {"two-plane", "spherical"}) {
        for (const Eye& eye : rival_named(name).layout(ball).eyes) {
            EXPECT_EQ(eye.camera.width_px, std::lround(side_px)) << name;
            EXPECT_EQ(eye.camera.height_px, std::lround(side_px)) << name;
        }
    }
}

TEST(RivalMethods, TwoPlaneStandsAsManyEyePointsInRowsAsTheCamerasReach) {
    std::vector<Eye> cameras;
    for (int column = 0; column < 11; ++column)
        for (int row = 0; row < 3; ++row)
            cameras.push_back(eye_at({0.2 * column - 1, 0.2 * row - 0.2, 0}, {0, 0, 4},
                                     pinhole_camera(64, 48, 60)));
    const LightFieldLayout slab =
        rival_named("two-plane").layout(photographed(AnalyticScene::kCardBeforeWall, cameras));
    ASSERT_EQ(slab.eyes.size(), 33U);
    const auto at = [&](std::size_t i) { return centre_in_world(slab.eyes[i].cam_from_world); };
    const double column_step = (at(1) - at(0)).norm();
    EXPECT_NEAR((at(11) - at(0)).norm(), column_step, 0.02 * column_step);
}

TEST(RivalMethods, SphericalHasTheNumberOfDirectionsNearestToThatOfPhotographs) {
    EXPECT_EQ(rival_named("spherical").layout(ball_in_sky()).eyes.size(), 12U);
    EXPECT_EQ(subdivisions_for(30), 1);
    EXPECT_EQ(subdivisions_for(107), 2) << "162 is nearer than 42";
}

TEST(RivalMethods, SphericalWantsCamerasAllAround) {
    EXPECT_THAT(rival_named("spherical").reason_against(ball_in_sky()), IsEmpty());
    EXPECT_THAT(rival_named("spherical").reason_against(card_before_wall()),
                HasSubstr("all around"));
}

TEST(RivalMethods, TwoPlaneWantsASurfaceOfCameras) {
    EXPECT_THAT(rival_named("two-plane").reason_against(card_without_surface()),
                HasSubstr("no surface"));
    Lumigraph row = card_before_wall();
    row.mesh.construction = MeshConstruction::kLine;
    EXPECT_THAT(rival_named("two-plane").reason_against(row), HasSubstr("in a line"));
}

}  // namespace
}  // namespace lumi
