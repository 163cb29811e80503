#include "render/viewer/input_events.h"

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace lumi {
namespace {

constexpr int kLeft = GLFW_MOUSE_BUTTON_LEFT;
constexpr int kRight = GLFW_MOUSE_BUTTON_RIGHT;

/// A cursor that begins at (10, 20); time goes on a second with each press.
class InputEventsTest : public testing::Test {
 protected:
    void press(int button) { events_.button_changed(button, true, clock_s_ += 1.0); }
    void release(int button) { events_.button_changed(button, false, clock_s_); }
    void move(double x, double y) { events_.cursor_moved_to({x, y}); }

    double clock_s_ = 0.0;
    InputEvents events_{{10, 20}};
};

TEST_F(InputEventsTest, TheWayOfTheCursorBeforeAPressIsNoDrag) {
    move(510, 120);
    press(kLeft);
    const WindowInput input = events_.taken();
    EXPECT_TRUE(input.left_button);
    EXPECT_EQ(input.drag_px, Eigen::Vector2d(0, 0));
    ASSERT_TRUE(input.pressed_at_px.has_value());
    EXPECT_EQ(*input.pressed_at_px, Eigen::Vector2d(510, 120));
}

TEST_F(InputEventsTest, ADragThatEndsBeforeAnybodyAsksIsWholeAndNothingAfterItCounts) {
    press(kLeft);
    move(110, 20);
    move(310, 50);
    release(kLeft);
    move(700, 400);
    const WindowInput input = events_.taken();
    EXPECT_TRUE(input.left_button);
    EXPECT_EQ(input.drag_px, Eigen::Vector2d(300, 30));
    EXPECT_EQ(*input.cursor_px, Eigen::Vector2d(700, 400));
    EXPECT_FALSE(events_.has_more());
    const WindowInput after = events_.taken();
    EXPECT_FALSE(after.left_button);
    EXPECT_TRUE(after.drag_px.isZero());
    EXPECT_FALSE(after.pressed_at_px.has_value());
}

TEST_F(InputEventsTest, ADragThatGoesOnIsGivenPieceByPiece) {
    press(kLeft);
    move(20, 20);
    EXPECT_EQ(events_.taken().drag_px, Eigen::Vector2d(10, 0));
    move(20, 50);
    const WindowInput second = events_.taken();
    EXPECT_TRUE(second.left_button);
    EXPECT_EQ(second.drag_px, Eigen::Vector2d(0, 30));
    EXPECT_FALSE(second.pressed_at_px.has_value());
}

TEST_F(InputEventsTest, DragsWithSeveralButtonsAndKeysComeOneAfterTheOther) {
    press(kLeft);
    move(15, 20);
    release(kLeft);
    move(100, 20);
    press(kRight);
    move(100, 27);
    release(kRight);
    events_.key_changed(GLFW_KEY_RIGHT_CONTROL, true);
    press(kLeft);
    move(97, 27);
    release(kLeft);
    events_.key_changed(GLFW_KEY_RIGHT_CONTROL, false);

    const WindowInput orbit = events_.taken();
    EXPECT_TRUE(orbit.left_button && !orbit.right_button && !orbit.control);
    EXPECT_EQ(orbit.drag_px, Eigen::Vector2d(5, 0));
    ASSERT_TRUE(events_.has_more());
    const WindowInput pan = events_.taken();
    EXPECT_TRUE(pan.right_button && !pan.left_button);
    EXPECT_EQ(pan.drag_px, Eigen::Vector2d(0, 7));
    const WindowInput look = events_.taken();
    EXPECT_TRUE(look.left_button && look.control);
    EXPECT_EQ(look.drag_px, Eigen::Vector2d(-3, 0));
    const WindowInput nothing = events_.taken();
    EXPECT_FALSE(nothing.left_button || nothing.right_button || nothing.control);
    EXPECT_FALSE(events_.has_more());
}

TEST_F(InputEventsTest, AKeyThatWasHeldShortlyFliesOnceAndOneThatIsHeldFliesOn) {
    events_.key_changed(GLFW_KEY_W, true);
    events_.key_changed(GLFW_KEY_W, false);
    EXPECT_EQ(events_.taken().flight, Eigen::Vector3d(0, 0, 1));
    EXPECT_TRUE(events_.taken().flight.isZero());
    events_.key_changed(GLFW_KEY_A, true);
    events_.key_changed(GLFW_KEY_Q, true);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(events_.taken().flight, Eigen::Vector3d(-1, 1, 0));
    events_.key_changed(GLFW_KEY_D, true);
    EXPECT_EQ(events_.taken().flight, Eigen::Vector3d(0, 1, 0)) << "left and right";
}

TEST_F(InputEventsTest, AKeyWithControlDoesNotFlyAlsoWhereBothWereLetGo) {
    events_.key_changed(GLFW_KEY_LEFT_CONTROL, true);
    events_.key_changed(GLFW_KEY_S, true);
    events_.asked_for(Command::kScreenshot);
    events_.key_changed(GLFW_KEY_S, false);
    events_.key_changed(GLFW_KEY_LEFT_CONTROL, false);
    const WindowInput input = events_.taken();
    EXPECT_TRUE(input.flight.isZero());
    EXPECT_EQ(input.commands, std::vector{Command::kScreenshot});
}

TEST_F(InputEventsTest, TwoPressesSoonAfterEachOtherAtOnePlaceAreADoubleClick) {
    const auto click = [&](double x, double clock_s) {
        move(x, 40);
        events_.button_changed(kLeft, true, clock_s);
        events_.button_changed(kLeft, false, clock_s);
        return events_.taken().double_clicked_at_px;
    };
    EXPECT_FALSE(click(50, 1.0).has_value());
    EXPECT_EQ(click(52, 1.2), Eigen::Vector2d(52, 40));
    EXPECT_FALSE(click(52, 1.4).has_value()) << "the third is none";
    EXPECT_FALSE(click(52, 9.0).has_value());
    EXPECT_FALSE(click(52, 9.6).has_value()) << "too late";
    EXPECT_FALSE(click(90, 9.8).has_value()) << "too far";
}

}  // namespace
}  // namespace lumi
