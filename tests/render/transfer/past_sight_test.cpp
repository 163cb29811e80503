#include "render/transfer/past_sight.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr double kLeastDifference = 0.01;

TEST(PastSight, IsPastWhatAViewDoesNotSeeThoughNothingHidesIt) {
    const Lumigraph lumigraph = post_behind_post();
    const Eye eye = eye_at({0, 0, 0}, {0, 0, 4}, pinhole_camera(61, 45, 60));
    const Eigen::Vector2d along_axis(30.5, 22.5);
    const auto is_past = [&](std::size_t view, double z) {
        return PastSight(lumigraph.views[view], eye).past(along_axis, 1 / z, kLeastDifference) !=
               Past::kNot;
    };
    EXPECT_TRUE(is_past(0, 2));     // Nothing is there,
    EXPECT_FALSE(is_past(0, 4.5));  // there it sees the far post,
    EXPECT_FALSE(is_past(0, 6));    // which hides the wall.
    EXPECT_TRUE(is_past(1, 2));
    EXPECT_FALSE(is_past(1, 4.5));  // The near post hides the far one,
    EXPECT_FALSE(is_past(1, 6));    // and there it sees the wall.
    EXPECT_FALSE(is_past(1, 0.3));  // Outside of its photograph.
}

TEST(PastSight, IsPastAsFarAsItIsAskedFor) {
    const Lumigraph lumigraph = post_behind_post();
    const Eye eye = eye_at({0, 0, 0}, {0, 0, 4}, pinhole_camera(61, 45, 60));
    const auto is_past_to = [&](double nearest_seen) {
        return PastSight(lumigraph.views[0], eye)
                   .past({30.5, 22.5}, 0.5, kLeastDifference, nearest_seen) != Past::kNot;
    };
    EXPECT_TRUE(is_past_to(kAnywhere));
    EXPECT_FALSE(is_past_to(0.01));  // What it sees behind the point is no farther than the wall.
}

TEST(PastSight, IsNeverPastWhatLiesBehindTheView) {
    const Lumigraph lumigraph = post_behind_post();
    const Eye eye = eye_at({0, 0, -5}, {0, 0, 4}, pinhole_camera(61, 45, 60));
    EXPECT_EQ(PastSight(lumigraph.views[0], eye).past({30.5, 22.5}, 1.0, kLeastDifference),
              Past::kNot);
}

TEST(PastSight, IsSureOfWhatSeveralViewsAgreeOn) {
    Lumigraph lumigraph = post_behind_post();
    LumigraphView& view = lumigraph.views[0];
    const Eye eye = eye_at({0, 0, 0}, {0, 0, 4}, pinhole_camera(61, 45, 60));
    const auto past = [&] {
        return PastSight(view, eye).past({30.5, 22.5}, 0.5, kLeastDifference);
    };
    EXPECT_EQ(past(), Past::kSurely);
    for (std::uint8_t& confidence : view.depth.confidence.pixels()) confidence = 128;
    EXPECT_EQ(past(), Past::kPerhaps);
    view.depth.confidence = GrayImage(128, 96, 255);
    view.depth.inverse_depth = FloatImage(128, 96, 0.0F);
    EXPECT_EQ(past(), Past::kPerhaps);  // Behind a mask.
}

}  // namespace
}  // namespace lumi
