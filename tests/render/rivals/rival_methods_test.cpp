#include "render/rivals/rival_methods.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

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

TEST(RivalMethods, InPlainCodeNeedDepthOfEveryPhotograph) {
    Lumigraph lumigraph = card_before_wall();
    for (const PlainRival& rival : plain_rivals())
        EXPECT_THAT(rival.reason_against(lumigraph), IsEmpty()) << rival.name;
    lumigraph.views[3].depth = {};
    for (const PlainRival& rival : plain_rivals())
        EXPECT_THAT(rival.reason_against(lumigraph), HasSubstr("1 of 9 photographs")) << rival.name;
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

TEST(RivalMethods, PicturesAreSquareWithThePixelsOfAPhotograph) {
    // Of 64 x 48: the square of 55.4.
    for (const Eye& eye : rival_named("two-plane").layout(card_before_wall()).eyes) {
        EXPECT_EQ(eye.camera.width_px, 55);
        EXPECT_EQ(eye.camera.height_px, 55);
    }
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
