#include "render/reference/point_in_views.h"

#include <gtest/gtest.h>

#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

// Past the card the wall is 6 away, also for an eye beside the camera in the middle.
TEST(PointInViews, AViewThatWasAskedForDepthSaysItselfWhetherItSeesAPoint) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0.4, 0, 0}, {0.4, 0, 4}, lumigraph.views[0].camera);
    const RenderOptions options;
    const PointInViews views(lumigraph, eye, options);
    const double wall = 1.0 / 6;
    const double card = 1.0 / 3;
    const RayPoint on_wall{unproject(eye.camera, {2.5, 2.5}), wall};
    const auto visibility = [&](const std::map<int, EyeDepth>& asked) {
        return views.visibility(0, on_wall, asked);
    };
    EXPECT_EQ(visibility({}), 1.0);
    EXPECT_EQ(visibility({{0, {wall, DepthKind::kSeen}}}), 1.0);
    EXPECT_EQ(visibility({{0, {wall, DepthKind::kFilled}}}), 1.0);
    EXPECT_EQ(visibility({{0, {wall, DepthKind::kStretched}}}), 0.0);
    EXPECT_EQ(visibility({{0, {card, DepthKind::kSeen}}}), 0.0);
    EXPECT_EQ(visibility({{0, {}}}), 0.0);
    EXPECT_EQ(visibility({{1, {card, DepthKind::kSeen}}}), 1.0);
}

// Nothing moves between them, whatever it knows of depth.
TEST(PointInViews, AViewWhereTheEyeIsSeesAllThatTheEyeSees) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye{lumigraph.views[0].camera, lumigraph.views[0].cam_from_world};
    const RenderOptions options;
    const PointInViews views(lumigraph, eye, options);
    const RayPoint on_wall{unproject(eye.camera, {2.5, 2.5}), 1.0 / 6};
    EXPECT_EQ(views.visibility(0, on_wall, {{0, {}}}), 1.0);
    EXPECT_EQ(views.visibility(0, on_wall, {{0, {1.0 / 3, DepthKind::kStretched}}}), 1.0);
}

}  // namespace
}  // namespace lumi
