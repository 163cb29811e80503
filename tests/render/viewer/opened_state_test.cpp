#include <gtest/gtest.h>

#include "render/viewer/commands.h"
#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

TEST(StateAfterOpening, KeepsWhatWasChosenAndForgetsWhereTheEyeWas) {
    const Lumigraph lumigraph = tiny_lumigraph();
    ViewerState state = first_state(lumigraph, {.mode = RenderMode::kAdaptive});
    state.frames_per_second = 24;
    state.shows_help = true;
    state.shows_panel = false;
    state.waits_for_vsync = false;
    state.fills_screen = true;
    state.exposures = Exposures::kAsTaken;
    state.planned = {{{}, "two steps to the left"}};
    state.package = "a.lumi";
    go_to_photograph(2, lumigraph, state);
    state.planned_index = 0;
    state.compared_index = 1;
    state.shows_difference = true;
    state.has_path = state.records_path = state.replays_path = true;
    state.wants_screenshot = true;
    state.package_to_open = "b.lumi";

    const ViewerState after = state_after_opening(lumigraph, state);
    EXPECT_EQ(after.render, state.render);
    EXPECT_EQ(after.frames_per_second, 24);
    EXPECT_TRUE(after.shows_help);
    EXPECT_FALSE(after.shows_panel);
    EXPECT_FALSE(after.waits_for_vsync);
    EXPECT_TRUE(after.fills_screen);
    EXPECT_EQ(after.exposures, Exposures::kAsTaken);
    EXPECT_EQ(after.planned.size(), 1U);
    EXPECT_EQ(after.package, "a.lumi");
    EXPECT_EQ(after.view_index, 0);
    EXPECT_EQ(after.planned_index, -1);
    EXPECT_EQ(after.compared_index, -1);
    EXPECT_FALSE(after.shows_difference);
    EXPECT_FALSE(after.has_path || after.records_path || after.replays_path);
    EXPECT_FALSE(after.wants_screenshot);
    EXPECT_TRUE(after.package_to_open.empty());
}

}  // namespace
}  // namespace lumi
