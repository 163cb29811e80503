#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "render/paths/photograph_eye.h"
#include "render/viewer/commands.h"
#include "render/viewer/recent_packages.h"
#include "render/viewer/screenshot.h"
#include "render/viewer/window_input.h"
#include "render/viewer/window_size.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

Eigen::Vector3d place(const ViewerState& state) {
    return centre_in_world(state.navigation.eye.cam_from_world);
}

class ViewerStateTest : public testing::Test {
 protected:
    ViewerStateTest() {
        // The tiny poses are odd on purpose: here they stand at places one can move about in.
        for (LumigraphView& view : lumigraph_.views) view.cam_from_world.translation.z() = 1.0;
        state_ = first_state(lumigraph_, {});
    }
    void apply_command(Command command) { apply(command, lumigraph_, state_); }

    Lumigraph lumigraph_ = tiny_lumigraph();
    ViewerState state_;
};

TEST(KeyBindings, NoKeyMeansTwoThingsAndEveryCommandHasAKeyAndHelp) {
    std::set<std::pair<int, bool>> keys;
    std::set<Command> commands;
    for (const KeyBinding& binding : key_bindings()) {
        EXPECT_TRUE(keys.insert({binding.key, binding.with_control}).second) << binding.shown;
        EXPECT_GT(std::string(binding.help).size(), 3U);
        commands.insert(binding.command);
    }
    EXPECT_EQ(commands.size(), static_cast<std::size_t>(Command::kQuit) + 1);
}

TEST(KeyBindings, LeaveTheLettersThatFlyAlone) {
    for (const int key : {GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_Q, GLFW_KEY_E}) {
        EXPECT_FALSE(command_of(key, false).has_value()) << static_cast<char>(key);
    }
    EXPECT_EQ(command_of(GLFW_KEY_F12, false), Command::kScreenshot);
    EXPECT_EQ(command_of(GLFW_KEY_S, true), Command::kScreenshot);
}

TEST(RecentPackages, ComeLastOpenedFirstOnceEachAndAtMostTen) {
    const ScratchFolder scratch;
    const std::filesystem::path file = scratch / "state/lumi/recent";
    EXPECT_TRUE(read_recent_packages(file).empty());
    std::vector<std::filesystem::path> packages;
    for (int i = 0; i < 12; ++i) {
        packages.push_back(std::filesystem::canonical(scratch.path()) /
                           ("a package " + std::to_string(i) + ".lumi"));
        std::filesystem::create_directory(packages.back());
        put_file(packages.back() / "lumigraph.json", "{}");
        remember_package(packages.back(), file);
    }
    remember_package(packages[5], file);
    std::vector<std::filesystem::path> read = read_recent_packages(file);
    ASSERT_EQ(read.size(), 10U);
    EXPECT_EQ(read[0], packages[5]);
    EXPECT_EQ(read[1], packages[11]);
    EXPECT_EQ(std::count(read.begin(), read.end(), packages[5]), 1);
    std::filesystem::remove_all(packages[11]);
    EXPECT_EQ(read_recent_packages(file)[1], packages[10]);
    put_file(file, std::string(100, '\0') + "\nrelative\n" + packages[0].string() + "\n");
    EXPECT_EQ(read_recent_packages(file), std::vector{packages[0]});
    remember_package(scratch / "nothing.lumi", file);
    EXPECT_EQ(read_recent_packages(file), std::vector{packages[0]});
}

TEST_F(ViewerStateTest, StandsWhereAPhotographIsPlanned) {
    go_to_planned(0, lumigraph_, state_);
    EXPECT_EQ(state_.planned_index, -1);  // There is no plan.
    const Rigid3 pose{Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY())),
                      {0.2, -0.1, 4}};
    state_.planned = {{Rigid3{}, "go left"}, {pose, "go up"}};
    go_to_planned(1, lumigraph_, state_);
    EXPECT_EQ(state_.planned_index, 1);
    EXPECT_LT((place(state_) - centre_in_world(pose)).norm(), 1e-12);
    EXPECT_EQ(state_.navigation.pivot_in_world, lumigraph_.mesh.scene_centre_in_world);
    const Eigen::Vector3d there = place(state_);
    go_to_planned(2, lumigraph_, state_);
    EXPECT_EQ(place(state_), there);
}

TEST_F(ViewerStateTest, StepsThroughThePhotographsAndWrapsAround) {
    EXPECT_EQ(state_.view_index, 0);
    apply_command(Command::kPreviousPhotograph);
    EXPECT_EQ(state_.view_index, 2);
    apply_command(Command::kNextPhotograph);
    apply_command(Command::kNextPhotograph);
    EXPECT_EQ(state_.view_index, 1);
    EXPECT_LT((place(state_) - centre_in_world(lumigraph_.views[1].cam_from_world)).norm(), 1e-12);
}

TEST_F(ViewerStateTest, StandsAtAPhotographOnlyUntilTheEyeMoves) {
    go_to_photograph(1, lumigraph_, state_);
    EXPECT_EQ(photograph_stood_at(lumigraph_, state_), 1);
    state_.navigation = pan(state_.navigation, {0.01, 0.01});
    EXPECT_FALSE(photograph_stood_at(lumigraph_, state_).has_value());
}

TEST_F(ViewerStateTest, StepsToThePhotographsBesideTheNearestOneWhereTheEyeHasMovedAway) {
    for (const auto& [command, expected] :
         {std::pair{Command::kNextPhotograph, 0}, {Command::kPreviousPhotograph, 1}}) {
        go_to_photograph(0, lumigraph_, state_);
        state_.navigation = snap_to(state_.navigation, lumigraph_, 2);
        state_.navigation = pan(state_.navigation, {0.01, 0.01});
        ASSERT_EQ(nearest_view(lumigraph_, state_.navigation.eye), 2);
        apply_command(command);
        EXPECT_EQ(state_.view_index, expected);
    }
}

TEST_F(ViewerStateTest, ComparesAgainAndThenWithTheNextHeldOutPhotograph) {
    std::vector<HeldOutView> held_out(2);
    held_out[0] = {"a", eye_at(lumigraph_.views[1]), {}};
    held_out[1] = {"b", eye_at(lumigraph_.views[2]), {}};
    const auto compare = [&] { compare_again_or_next(held_out, lumigraph_, state_); };
    compare_again_or_next({}, lumigraph_, state_);
    EXPECT_FALSE(is_compared(held_out, state_));
    compare();
    EXPECT_EQ(state_.compared_index, 0);
    EXPECT_TRUE(is_compared(held_out, state_));
    state_.enlargement = {2.0, {-0.5, -0.5}};
    compare();
    EXPECT_EQ(state_.compared_index, 1);
    EXPECT_EQ(state_.enlargement.times, 1.0);
    state_.navigation = pan(state_.navigation, {0.01, 0.01});
    EXPECT_FALSE(is_compared(held_out, state_));
    compare();
    EXPECT_EQ(state_.compared_index, 1) << "again";
    compare();
    EXPECT_EQ(state_.compared_index, 0) << "after the last the first";
}

TEST(Enlargement, KeepsThePlaceUnderTheCursorAndThePictureOverTheFrame) {
    const Eigen::Vector2d frame(640, 480);
    const Eigen::Vector2d cursor(500, 100);
    Enlargement enlargement;
    for (int step = 0; step < 8; ++step) {
        enlargement = enlarged_about(enlargement, cursor.cwiseQuotient(frame), 1.0);
        EXPECT_LT((enlargement.place(cursor, frame) - cursor).norm(), 1e-9);
    }
    EXPECT_NEAR(enlargement.times, std::pow(1.25, 8), 1e-9);
    // Back at another place, it must not leave a part of the frame empty.
    for (int step = 0; step < 8; ++step) {
        enlargement = enlarged_about(enlargement, {0.0, 0.9}, -1.0);
        EXPECT_LE(enlargement.place({0, 0}, frame).maxCoeff(), 1e-9);
        EXPECT_GE((enlargement.place(frame, frame) - frame).minCoeff(), -1e-9);
    }
    EXPECT_NEAR(enlargement.times, 1.0, 1e-9);
    EXPECT_EQ(enlarged_about(enlargement, {0.5, 0.5}, -5.0).times, 1.0);
}

TEST_F(ViewerStateTest, TheWheelEnlargesOnceAndMovesNothingThen) {
    WindowInput input;
    input.wheel_steps = 2.0;
    Enlargement enlargement;
    EXPECT_TRUE(enlarge(input, {320, 240}, enlargement));
    EXPECT_NEAR(enlargement.times, 1.5625, 1e-12);
    EXPECT_FALSE(enlarge(input, {320, 240}, enlargement));
    EXPECT_FALSE(steer(input, 0.02, 320, 240, state_.navigation));
}

TEST_F(ViewerStateTest, HomeStandsAtTheNearestPhotograph) {
    apply_command(Command::kNextPhotograph);
    state_.navigation = pan(state_.navigation, {0.01, 0.01});
    const Eigen::Vector3d moved_to = place(state_);
    apply_command(Command::kNearestPhotograph);
    EXPECT_EQ(state_.view_index, 1);
    EXPECT_GT((place(state_) - moved_to).norm(), 0.0);
    EXPECT_LT((place(state_) - centre_in_world(lumigraph_.views[1].cam_from_world)).norm(), 1e-12);
}

TEST_F(ViewerStateTest, ADebugPictureIsPutAwayByItsOwnKeyAndReplacedByAnother) {
    apply_command(Command::kShowWeights);
    EXPECT_EQ(state_.render.debug_picture, DebugPicture::kWeights);
    apply_command(Command::kShowDepth);
    EXPECT_EQ(state_.render.debug_picture, DebugPicture::kDepth);
    apply_command(Command::kShowDepth);
    EXPECT_EQ(state_.render.debug_picture, DebugPicture::kNone);
}

TEST_F(ViewerStateTest, TogglesComeBack) {
    const RenderOptions before = state_.render;
    for (const Command command : {Command::kOcclusion, Command::kHelp, Command::kPanel,
                                  Command::kFullScreen, Command::kVsync}) {
        apply_command(command);
        apply_command(command);
    }
    EXPECT_EQ(state_.render.correct_occlusion, before.correct_occlusion);
    EXPECT_FALSE(state_.shows_help);
    EXPECT_TRUE(state_.shows_panel);
    EXPECT_FALSE(state_.fills_screen);
    EXPECT_TRUE(state_.waits_for_vsync);
}

TEST_F(ViewerStateTest, EscapeClosesTheHelpBeforeItEndsTheProgram) {
    EXPECT_EQ(command_of(GLFW_KEY_ESCAPE, false), Command::kBack);
    state_.shows_help = true;
    apply_command(Command::kBack);
    EXPECT_FALSE(state_.shows_help);
    EXPECT_FALSE(state_.wants_to_close);
    state_.fills_screen = true;
    apply_command(Command::kBack);
    EXPECT_FALSE(state_.fills_screen);
    EXPECT_FALSE(state_.wants_to_close);
    apply_command(Command::kBack);
    EXPECT_TRUE(state_.wants_to_close);
}

TEST_F(ViewerStateTest, NextModeComesToAllModesInTheirOrder) {
    const std::vector<RenderMode> all = all_render_modes();
    state_.render.mode = all.front();
    for (std::size_t i = 1; i <= all.size(); ++i) {
        apply_command(Command::kNextMode);
        EXPECT_EQ(state_.render.mode, all[i % all.size()]);
    }
}

TEST_F(ViewerStateTest, NextPictureComesToAllDebugPicturesInTheirOrder) {
    const std::vector<DebugPicture> all = all_debug_pictures();
    state_.render.debug_picture = all.front();
    for (std::size_t i = 1; i <= all.size(); ++i) {
        apply_command(Command::kNextPicture);
        EXPECT_EQ(state_.render.debug_picture, all[i % all.size()]);
    }
}

TEST_F(ViewerStateTest, EveryModeAndEveryDebugPictureHasAKeyOfItsOwn) {
    std::set<RenderMode> modes;
    std::set<DebugPicture> pictures;
    for (const KeyBinding& binding : key_bindings()) {
        if (binding.command == Command::kNextMode || binding.command == Command::kNextPicture)
            continue;
        state_.render = {};
        apply_command(binding.command);
        modes.insert(state_.render.mode);
        pictures.insert(state_.render.debug_picture);
    }
    EXPECT_EQ(modes.size(), all_render_modes().size());
    EXPECT_EQ(pictures.size(), all_debug_pictures().size());
}

TEST_F(ViewerStateTest, APathIsReplayedWhereThereIsOne) {
    apply_command(Command::kReplayPath);
    EXPECT_FALSE(state_.replays_path);
    state_.has_path = true;
    apply_command(Command::kReplayPath);
    EXPECT_TRUE(state_.replays_path);
    apply_command(Command::kReplayPath);
    EXPECT_FALSE(state_.replays_path);
}

TEST_F(ViewerStateTest, WhatMovesTheEyeOtherwiseEndsAReplay) {
    state_.has_path = true;
    for (const Command command : {Command::kPreviousPhotograph, Command::kNextPhotograph,
                                  Command::kNearestPhotograph, Command::kFrameAll}) {
        state_.replays_path = true;
        apply_command(command);
        EXPECT_FALSE(state_.replays_path) << static_cast<int>(command);
    }
    state_.planned = {{Rigid3{}, "go left"}};
    state_.replays_path = true;
    go_to_planned(0, lumigraph_, state_);
    EXPECT_FALSE(state_.replays_path);
    state_.replays_path = true;
    go_to_held_out(0, {{"kept back", state_.navigation.eye, {}}}, lumigraph_, state_);
    EXPECT_FALSE(state_.replays_path);

    state_.replays_path = true;
    apply_command(Command::kShowDepth);
    go_to_planned(7, lumigraph_, state_);
    EXPECT_TRUE(state_.replays_path) << "the eye did not move";
}

TEST(WindowSize, IsThatOfThePictureWhereItHoldsThePanelAndFitsOnAScreen) {
    const auto size = [](int width_px, int height_px) {
        return window_size_px(pinhole_camera(width_px, height_px, 500));
    };
    EXPECT_EQ(size(1200, 800), Eigen::Vector2i(1200, 800));
    EXPECT_EQ(size(768, 512), Eigen::Vector2i(960, 640));
    EXPECT_EQ(size(640, 480), Eigen::Vector2i(960, 720));
    EXPECT_EQ(size(600, 800), Eigen::Vector2i(960, 900))
        << "no window of its shape holds the panel";
    EXPECT_EQ(size(4000, 500), Eigen::Vector2i(1600, 640)) << "nor here";
    EXPECT_EQ(size(6000, 4000), Eigen::Vector2i(1350, 900));
}

TEST_F(ViewerStateTest, NothingPressedMovesNothing) {
    const Eigen::Vector3d before = place(state_);
    WindowInput input;
    input.drag_px = {50, 50};  // The cursor moves with no button held.
    EXPECT_FALSE(steer(input, 0.02, 130, 70, state_.navigation));
    EXPECT_EQ(place(state_), before);
}

TEST_F(ViewerStateTest, DragsAreMeasuredInPixelsOfTheWindow) {
    // The window shows the 13 x 7 picture ten times larger: ten pixels there are one here.
    WindowInput input;
    input.right_button = true;
    input.drag_px = {10, -20};
    const Navigation expected = pan(state_.navigation, {1, -2});
    EXPECT_TRUE(steer(input, 0.02, 130, 70, state_.navigation));
    EXPECT_LT((place(state_) - centre_in_world(expected.eye.cam_from_world)).norm(), 1e-12);
}

TEST_F(ViewerStateTest, FlightDependsOnTimeAndNotOnFrames) {
    WindowInput input;
    input.flight = {0, 0, 1};
    Navigation slow = state_.navigation;
    Navigation quick = state_.navigation;
    for (int i = 0; i < 2; ++i) steer(input, 0.08, 130, 70, slow);
    for (int i = 0; i < 16; ++i) steer(input, 0.01, 130, 70, quick);
    EXPECT_LT((centre_in_world(slow.eye.cam_from_world) - centre_in_world(quick.eye.cam_from_world))
                  .norm(),
              1e-9);
    EXPECT_GT((centre_in_world(slow.eye.cam_from_world) - place(state_)).norm(), 0.0);
}

TEST_F(ViewerStateTest, ControlKeysDoNotFly) {
    WindowInput input;
    input.flight = {1, 0, 0};
    input.control = true;
    EXPECT_FALSE(steer(input, 0.02, 130, 70, state_.navigation));
}

TEST(Screenshot, HoldsThePixelsAndThePoseToTheBit) {
    const ScratchFolder scratch;
    const LumigraphView view = tiny_lumigraph().views[0];
    const Eye eye{view.camera, view.cam_from_world};
    const Frame frame{view.photograph, GrayImage(13, 7, 255), {}};
    write_screenshot(scratch / "shot.png", frame, eye, {}, Exposures::kEvened, "tiny\x1b");
    EXPECT_EQ(read_color_image(scratch / "shot.png"), view.photograph);

    const auto pose = nlohmann::json::parse(read_whole_text(scratch / "shot.json"));
    EXPECT_EQ(pose["camera"]["parameters"], view.camera.parameters);
    EXPECT_EQ(pose["mode"], "perpixel");
    EXPECT_EQ(pose["lumigraph"], "tiny\\x1b");
    const Eigen::Quaterniond& q = view.cam_from_world.rotation;
    EXPECT_EQ(pose["cam_from_world"]["rotation_wxyz"],
              (nlohmann::json{q.w(), q.x(), q.y(), q.z()}));
    const Eigen::Vector3d& t = view.cam_from_world.translation;
    EXPECT_EQ(pose["cam_from_world"]["translation"], (nlohmann::json{t.x(), t.y(), t.z()}));
}

TEST(Screenshot, TakesThePlaceOfAnotherButOfNoOtherFile) {
    const ScratchFolder scratch;
    const LumigraphView view = tiny_lumigraph().views[0];
    const Frame frame{view.photograph, GrayImage(13, 7, 255), {}};
    const auto write = [&] {
        write_screenshot(scratch / "shot.png", frame, {view.camera, view.cam_from_world}, {},
                         Exposures::kEvened, "tiny");
    };
    for (const char* text : {"{\"mine\": 1}", "no JSON", "[\"cam_from_world\"]", ""}) {
        write_whole_text(scratch / "shot.json", text);
        EXPECT_THROW(write(), Error) << text;
        EXPECT_EQ(read_whole_text(scratch / "shot.json"), text);
        EXPECT_FALSE(std::filesystem::exists(scratch / "shot.png"));
    }
    std::filesystem::remove(scratch / "shot.json");
    write();
    write();
}

TEST(Screenshot, NeverTakesANameThatIsTaken) {
    const ScratchFolder scratch;
    EXPECT_EQ(next_screenshot_path(scratch.path()), scratch / "lumi-0001.png");
    write_whole_text(scratch / "lumi-0001.png", "x");
    EXPECT_EQ(next_screenshot_path(scratch.path()), scratch / "lumi-0002.png");
    write_whole_text(scratch / "lumi-0002.json", "x");
    EXPECT_EQ(next_screenshot_path(scratch.path()), scratch / "lumi-0003.png");
}

}  // namespace
}  // namespace lumi
