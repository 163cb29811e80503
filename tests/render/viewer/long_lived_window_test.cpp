#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "render/lumigraph/package.h"
#include "render/lumigraph/same_eye.h"
#include "render/paths/photograph_eye.h"
#include "render/viewer/window.h"
#include "render/viewer/window_input.h"
#include "tests/calib/noted_progress.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/viewer/xvfb_display.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

const Lumigraph& shown_box() {
    static const Lumigraph lumigraph = [] {
        const SyntheticCapture scene = textured_box_scene();
        return exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    }();
    return lumigraph;
}

WindowOptions window_of_320x240() {
    WindowOptions options;
    options.width_px = 320;
    options.height_px = 240;
    return options;
}

/// A window to which things happen after it was opened, and a folder that it writes to.
class LongLivedWindow : public testing::Test {
 protected:
    static void SetUpTestSuite() { display = std::make_unique<XvfbDisplay>(); }
    static void TearDownTestSuite() { display.reset(); }
    void SetUp() override {
        if (!display->is_running()) GTEST_SKIP() << "no Xvfb here: install the package xvfb";
        fs::current_path(scratch_.path());
    }
    void TearDown() override { fs::current_path(before_); }

    static inline std::unique_ptr<XvfbDisplay> display;
    const fs::path before_ = fs::current_path();
    ScratchFolder scratch_;
};

TEST_F(LongLivedWindow, OpensAnotherPackageAndKeepsTheOldOneWhenItCannot) {
    const ScratchFolder scratch;
    Lumigraph other = shown_box();
    other.name = "other\x1b";
    other.views.resize(5);
    other.mesh = {};
    other.mesh.vertices = {{centre_in_world(other.views[2].cam_from_world), 2}};
    write_package(scratch / "other.lumi", other, {});

    WindowOptions options = window_of_320x240();
    options.recent_file = scratch / "recent";
    ViewerWindow window({shown_box()}, options);
    EXPECT_TRUE(window.state().recent_packages.empty());
    window.open_package(scratch / "nothing.lumi");
    EXPECT_NE(window.statistics().message.find("nothing.lumi"), std::string::npos);
    EXPECT_TRUE(window.step());
    window.write_screenshot_to(scratch / "old.png");
    window.open_package(scratch / "other.lumi/lumigraph.json");
    EXPECT_TRUE(window.step());
    window.write_screenshot_to(scratch / "new.png");
    EXPECT_EQ(window.state().recent_packages.size(), 1U);
    window.state().package_to_open = window.state().recent_packages[0];
    EXPECT_TRUE(window.step());
    EXPECT_NE(window.statistics().message.find("opened other"), std::string::npos);
    EXPECT_TRUE(window.state().package_to_open.empty());

    const auto name_in = [&](const char* file) {
        return nlohmann::json::parse(read_whole_text(scratch / file))["lumigraph"];
    };
    EXPECT_EQ(name_in("old.json"), shown_box().name);
    EXPECT_EQ(name_in("new.json"), "other\\x1b");
}

TEST_F(LongLivedWindow, StaysWhereMemoryOrTheFileSystemFailsWhatIsOpened) {
    WindowOptions options = window_of_320x240();
    options.load = [](const fs::path& package, Exposures) -> OpenedPackage {
        if (package == "large.lumi") throw std::bad_alloc();
        throw fs::filesystem_error("cannot look into", package,
                                   std::make_error_code(std::errc::permission_denied));
    };
    ViewerWindow window({shown_box()}, options);
    window.open_package("large.lumi");
    EXPECT_NE(window.statistics().message.find("memory"), std::string::npos);
    window.open_package("locked.lumi");
    EXPECT_NE(window.statistics().message.find("locked.lumi"), std::string::npos);
    EXPECT_TRUE(window.step());
}

TEST_F(LongLivedWindow, OpensFurtherPackagesAsTheFirstWithWhatLiesBesideThem) {
    std::vector<std::pair<fs::path, Exposures>> read;
    WindowOptions options = window_of_320x240();
    options.render.mode = RenderMode::kLightField;
    options.exposures = Exposures::kAsTaken;
    options.load = [&](const fs::path& package, Exposures exposures) {
        read.emplace_back(package, exposures);
        const LumigraphView& view = shown_box().views[4];
        return OpenedPackage{.lumigraph = shown_box(),
                             .fade_beyond_capture = true,
                             .planned = {{Rigid3{}, "go left"}},
                             .held_out = {{view.name, {view.camera, {}}, view.photograph}},
                             .message = "it rains"};
    };
    ViewerWindow window({shown_box()}, options);
    EXPECT_FALSE(window.state().render.fade_beyond_capture);
    window.open_package("other.lumi");
    EXPECT_EQ(read,
              (std::vector<std::pair<fs::path, Exposures>>{{"other.lumi", Exposures::kAsTaken}}));
    EXPECT_TRUE(window.state().render.fade_beyond_capture);
    EXPECT_EQ(window.state().render.mode, RenderMode::kLightField);
    EXPECT_EQ(window.state().planned.size(), 1U);
    EXPECT_EQ(window.held_out().size(), 1U);
    EXPECT_NE(window.statistics().message.find("it rains"), std::string::npos);
    EXPECT_TRUE(window.step());
}

TEST_F(LongLivedWindow, ReadsThePackageAgainWhereOtherExposuresAreWished) {
    std::vector<Exposures> read;
    WindowOptions options = window_of_320x240();
    options.package = "some.lumi";
    options.load = [&](const fs::path& package, Exposures exposures) -> OpenedPackage {
        EXPECT_EQ(package, "some.lumi");
        read.push_back(exposures);
        if (read.size() > 1) throw Error(ErrorKind::kBadInput, "E-GONE", "it is gone", "look");
        return {shown_box()};
    };
    ViewerWindow window({shown_box(), true}, options);
    ASSERT_TRUE(window.step());
    window.state().navigation = orbit(window.state().navigation, {5, 3});
    const Eye eye = window.state().navigation.eye;
    window.state().exposures = Exposures::kAsTaken;
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(window.step());
    EXPECT_EQ(read, std::vector{Exposures::kAsTaken});
    EXPECT_TRUE(is_same_eye(window.state().navigation.eye, eye));
    EXPECT_TRUE(window.state().render.fade_beyond_capture) << "as it was";

    window.state().exposures = Exposures::kEvened;
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(window.step());
    EXPECT_EQ(read.size(), 2U);
    EXPECT_EQ(window.state().exposures, Exposures::kAsTaken);
    EXPECT_NE(window.statistics().message.find("it is gone"), std::string::npos);
}

TEST_F(LongLivedWindow, RecordsThePathAndReplaysItToItsEnd) {
    ViewerWindow window({shown_box()}, window_of_320x240());
    ViewerState& state = window.state();
    state.records_path = true;
    ASSERT_TRUE(window.step());
    const Eigen::Vector3d begun_at = centre_in_world(state.navigation.eye.cam_from_world);
    state.navigation = orbit(state.navigation, {60, 20});
    ASSERT_TRUE(window.step());
    const Eigen::Vector3d ended_at = centre_in_world(state.navigation.eye.cam_from_world);
    state.records_path = false;
    ASSERT_TRUE(window.step());
    EXPECT_TRUE(fs::exists("lumi-path-0001.json"));
    EXPECT_TRUE(state.has_path);

    state.navigation = frame_all(state.navigation, bounds_of(shown_box()));
    state.replays_path = true;
    ASSERT_TRUE(window.step());
    EXPECT_LT((centre_in_world(state.navigation.eye.cam_from_world) - begun_at).norm(), 1e-9);
    while (state.replays_path) ASSERT_TRUE(window.step());
    EXPECT_LT((centre_in_world(state.navigation.eye.cam_from_world) - ended_at).norm(), 1e-9);
}

/// Of the pivot from the eye's optical axis, as a share of its distance.
double pivot_off_axis(const Navigation& navigation) {
    const Rigid3& cam_from_world = navigation.eye.cam_from_world;
    const Eigen::Vector3d to_pivot = navigation.pivot_in_world - centre_in_world(cam_from_world);
    return to_pivot.normalized().cross(optical_axis_in_world(cam_from_world)).norm();
}

TEST_F(LongLivedWindow, LeavesAReplayForThePhotographThatIsWished) {
    ViewerWindow window({shown_box()}, window_of_320x240());
    ViewerState& state = window.state();
    state.records_path = true;
    ASSERT_TRUE(window.step());
    for (int i = 0; i < 20; ++i) {
        state.navigation = orbit(state.navigation, {6, 2});
        ASSERT_TRUE(window.step());
    }
    state.records_path = false;
    ASSERT_TRUE(window.step());

    go_to_photograph(6, shown_box(), state);
    state.replays_path = true;
    ASSERT_TRUE(window.step());
    EXPECT_LT(pivot_off_axis(state.navigation), 1e-9) << "and not another photograph's";
    ASSERT_TRUE(state.replays_path);
    const auto next = static_cast<std::size_t>(nearest_view(shown_box(), state.navigation.eye) + 1);
    WindowInput input;
    input.commands = {Command::kNextPhotograph};
    ASSERT_TRUE(window.step(&input));
    EXPECT_FALSE(state.replays_path);
    EXPECT_TRUE(is_same_eye(state.navigation.eye,
                            eye_at(shown_box().views[next % shown_box().views.size()])));
}

TEST_F(LongLivedWindow, SaysThatItsFolderIsGoneAndStays) {
    const fs::path gone = scratch_ / "gone";
    fs::create_directory(gone);
    fs::current_path(gone);
    fs::remove(gone);
    ViewerWindow window({shown_box()}, window_of_320x240());
    ViewerState& state = window.state();
    ASSERT_TRUE(window.step());
    state.wants_screenshot = true;
    ASSERT_TRUE(window.step());
    EXPECT_NE(window.statistics().message.find("lumi-0001.png"), std::string::npos);
    state.records_path = true;
    ASSERT_TRUE(window.step());
    state.records_path = false;
    ASSERT_TRUE(window.step());
    EXPECT_NE(window.statistics().message.find("lumi-path-0001.json"), std::string::npos);
}

TEST_F(LongLivedWindow, WritesAPathAgainThatCouldNotBeWritten) {
    const fs::path gone = scratch_ / "gone";
    fs::create_directory(gone);
    ViewerWindow window({shown_box()}, window_of_320x240());
    ViewerState& state = window.state();
    state.records_path = true;
    ASSERT_TRUE(window.step());
    fs::current_path(gone);
    fs::remove(gone);
    state.records_path = false;
    ASSERT_TRUE(window.step());
    EXPECT_TRUE(window.statistics().has_failed);
    EXPECT_TRUE(state.has_unwritten_path);
    const int told = window.statistics().messages;
    ASSERT_TRUE(window.step());
    EXPECT_EQ(window.statistics().messages, told) << "once";

    fs::current_path(scratch_.path());
    state.writes_path_again = true;
    ASSERT_TRUE(window.step());
    EXPECT_TRUE(fs::exists("lumi-path-0001.json"));
    EXPECT_FALSE(window.statistics().has_failed);
    EXPECT_FALSE(state.has_unwritten_path);
    state.wants_to_close = true;
    EXPECT_FALSE(window.step());
    EXPECT_FALSE(fs::exists("lumi-path-0002.json"));
}

TEST_F(LongLivedWindow, TriesOnceMoreToWriteAPathWhenItIsClosed) {
    const fs::path gone = scratch_ / "gone";
    fs::create_directory(gone);
    ViewerWindow window({shown_box()}, window_of_320x240());
    window.state().records_path = true;
    ASSERT_TRUE(window.step());
    fs::current_path(gone);
    fs::remove(gone);
    window.state().records_path = false;
    ASSERT_TRUE(window.step());
    fs::current_path(scratch_.path());
    window.state().wants_to_close = true;
    EXPECT_FALSE(window.step());
    EXPECT_TRUE(fs::exists("lumi-path-0001.json"));
}

TEST_F(LongLivedWindow, NamesWhatItWritesByItsWholePath) {
    ViewerWindow window({shown_box()}, window_of_320x240());
    window.state().wants_screenshot = true;
    ASSERT_TRUE(window.step());
    const std::string path = (fs::current_path() / "lumi-0001.png").string();
    EXPECT_EQ(window.statistics().message, "wrote " + path);
}

TEST_F(LongLivedWindow, FillsTheScreenAndComesBackAsItWas) {
    ViewerWindow window({shown_box()}, window_of_320x240());
    ASSERT_TRUE(window.step());
    window.state().fills_screen = true;
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(window.step());
    EXPECT_EQ(window.statistics().width_px, 1280) << "the screen's";
    window.state().fills_screen = false;
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(window.step());
    EXPECT_EQ(window.statistics().width_px, 320);
}

TEST_F(LongLivedWindow, EnlargesWhatIsComparedByTheWheelAndGoesBackToIt) {
    const LumigraphView& view = shown_box().views[4];
    OpenedPackage opened{.lumigraph = shown_box(),
                         .held_out = {{view.name, eye_at(view), view.photograph}}};
    ViewerWindow window(std::move(opened), window_of_320x240());
    WindowInput input;
    input.commands = {Command::kCompare};
    ASSERT_TRUE(window.step(&input));
    ASSERT_TRUE(is_compared(window.held_out(), window.state()));
    input = {};
    input.wheel_steps = 4;
    input.cursor_px = Eigen::Vector2d(300, 200);
    ASSERT_TRUE(window.step(&input));
    EXPECT_TRUE(is_compared(window.held_out(), window.state()));
    EXPECT_GT(window.state().enlargement.times, 2.0);
    input.wheel_steps = 0;
    input.right_button = true;
    input.drag_px = {20, 0};
    input.pressed_at_px = Eigen::Vector2d(300, 200);
    ASSERT_TRUE(window.step(&input));
    EXPECT_FALSE(is_compared(window.held_out(), window.state()));
    EXPECT_EQ(window.state().enlargement.times, 1.0);
}

TEST_F(LongLivedWindow, TellsOfAPictureThatItWritesWhileAPathIsRecorded) {
    ViewerWindow window({shown_box()}, window_of_320x240());
    window.state().records_path = true;
    window.state().wants_screenshot = true;
    ASSERT_TRUE(window.step());
    ASSERT_TRUE(window.step());
    EXPECT_NE(window.statistics().message.find("lumi-0001.png"), std::string::npos);
    EXPECT_NE(window.statistics().recording.find("recording"), std::string::npos);
    window.state().records_path = false;
    ASSERT_TRUE(window.step());
    EXPECT_TRUE(window.statistics().recording.empty());
    EXPECT_NE(window.statistics().message.find("lumi-path-0001.json"), std::string::npos);
}

TEST_F(LongLivedWindow, WritesThePathThatIsRecordedWhenItIsClosed) {
    ViewerWindow window({shown_box()}, window_of_320x240());
    window.state().records_path = true;
    ASSERT_TRUE(window.step());
    window.state().wants_to_close = true;
    EXPECT_FALSE(window.step());
    EXPECT_TRUE(fs::exists("lumi-path-0001.json"));
}

/// A window that ends in an error where a package is dropped on it.
WindowOptions that_fails_to_load(Progress& progress) {
    WindowOptions options = window_of_320x240();
    options.load = [](const fs::path&, Exposures) -> OpenedPackage {
        throw std::logic_error("a bug");
    };
    options.progress = &progress;
    return options;
}

TEST_F(LongLivedWindow, WritesThePathThatIsRecordedWhenItEndsInAnError) {
    NotedProgress progress;
    ViewerWindow window({shown_box()}, that_fails_to_load(progress));
    window.state().records_path = true;
    ASSERT_TRUE(window.step());
    WindowInput input;
    input.dropped = {"other.lumi"};
    EXPECT_THROW(window.step(&input), std::logic_error);
    EXPECT_TRUE(fs::exists("lumi-path-0001.json"));
    EXPECT_THAT(progress.notes, testing::ElementsAre(testing::HasSubstr("lumi-path-0001.json")));
}

TEST_F(LongLivedWindow, EndsInItsFirstErrorWhereThePathCannotBeWrittenEither) {
    const fs::path gone = scratch_ / "gone";
    fs::create_directory(gone);
    NotedProgress progress;
    ViewerWindow window({shown_box()}, that_fails_to_load(progress));
    window.state().records_path = true;
    ASSERT_TRUE(window.step());
    fs::current_path(gone);
    fs::remove(gone);
    WindowInput input;
    input.dropped = {"other.lumi"};
    EXPECT_THROW(window.step(&input), std::logic_error);
    fs::current_path(scratch_.path());
    EXPECT_EQ(progress.notes.size(), 1U);
}

TEST_F(LongLivedWindow, HasNoPathOfAnotherPackageToReplay) {
    WindowOptions options = window_of_320x240();
    options.load = [](const fs::path&, Exposures) { return OpenedPackage{shown_box()}; };
    ViewerWindow window({shown_box()}, options);
    window.state().records_path = true;
    ASSERT_TRUE(window.step());
    window.open_package("other.lumi");
    EXPECT_TRUE(fs::exists("lumi-path-0001.json")) << "it is not lost";
    EXPECT_FALSE(window.state().has_path);
    EXPECT_FALSE(window.state().records_path);
}

/// Two eyes, 0.3 seconds apart, of which the second is 0.2 to the right; of "shot.json" the first.
std::vector<TimedEye> eyes_read_from(const fs::path& file) {
    const Eye first = eye_at(shown_box().views[2]);
    Eye second = first;
    second.cam_from_world.translation.x() -= 0.2;
    if (file.filename() == "shot.json") return {{0.0, first}};
    if (file.filename() == "path.json") return {{0.0, first}, {0.3, second}};
    throw Error(ErrorKind::kBadInput, "E-JSON-READ", file.string() + ": is none", "mend it");
}

TEST_F(LongLivedWindow, StandsAtAScreenshotsEyeAndReplaysAPathThatAreDroppedOnIt) {
    WindowOptions options = window_of_320x240();
    options.read_eyes = eyes_read_from;
    options.load = [](const fs::path&, Exposures) -> OpenedPackage {
        throw Error(ErrorKind::kBadInput, "E-PACKAGE", "is no package", "");
    };
    ViewerWindow window({shown_box()}, options);
    const auto drop = [&](const char* file) {
        write_whole_text(file, "");
        WindowInput input;
        input.dropped = {file};
        EXPECT_TRUE(window.step(&input));
        return window.statistics().message;
    };
    EXPECT_EQ(drop("shot.json"), "stands at the eye of shot.json");
    EXPECT_TRUE(is_same_eye(window.state().navigation.eye, eyes_read_from("shot.json")[0].eye));
    EXPECT_FALSE(window.state().has_path);
    EXPECT_NE(drop("torn.json").find("torn.json: is none - mend it"), std::string::npos);
    EXPECT_NE(drop("notes.txt").find("is no package"), std::string::npos);

    window.state().records_path = true;
    ASSERT_TRUE(window.step());
    EXPECT_NE(drop("path.json").find("; replays path.json"), std::string::npos);
    EXPECT_TRUE(fs::exists("lumi-path-0001.json")) << "what was recorded is not lost";
    EXPECT_TRUE(window.state().has_path);
    while (window.state().replays_path) ASSERT_TRUE(window.step());
    EXPECT_TRUE(is_same_eye(window.state().navigation.eye, eyes_read_from("path.json")[1].eye));
}

TEST_F(LongLivedWindow, BeginsAtAnEye) {
    WindowOptions options = window_of_320x240();
    options.eyes = eyes_read_from("shot.json");
    ViewerWindow window({shown_box()}, options);
    EXPECT_TRUE(is_same_eye(window.state().navigation.eye, options.eyes[0].eye));
    EXPECT_FALSE(window.state().replays_path);
}

TEST_F(LongLivedWindow, BeginsByReplayingAPath) {
    WindowOptions options = window_of_320x240();
    options.eyes = eyes_read_from("path.json");
    ViewerWindow window({shown_box()}, options);
    EXPECT_TRUE(window.state().replays_path);
    while (window.state().replays_path) ASSERT_TRUE(window.step());
    EXPECT_TRUE(is_same_eye(window.state().navigation.eye, options.eyes[1].eye));
}

TEST_F(LongLivedWindow, RecordsAJumpToAPhotographAsNoFlight) {
    ViewerWindow window({shown_box()}, window_of_320x240());
    window.state().records_path = true;
    ASSERT_TRUE(window.step());
    WindowInput input;
    input.commands = {Command::kNextPhotograph};
    ASSERT_TRUE(window.step(&input));
    window.state().records_path = false;
    ASSERT_TRUE(window.step());
    const auto eyes = nlohmann::json::parse(read_whole_text("lumi-path-0001.json")).at("eyes");
    ASSERT_EQ(eyes.size(), 3U);
    EXPECT_EQ(eyes[0].at("cam_from_world"), eyes[1].at("cam_from_world"));
    EXPECT_NE(eyes[1].at("cam_from_world"), eyes[2].at("cam_from_world"));
    EXPECT_EQ(eyes[1].at("time_s"), eyes[2].at("time_s"));
}

}  // namespace
}  // namespace lumi
