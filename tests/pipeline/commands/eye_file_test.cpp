#include "pipeline/commands/eye_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "render/lumigraph/same_eye.h"
#include "render/viewer/screenshot.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kEyeAlone =
    R"("camera": {"model": "PINHOLE", "width_px": 4, "height_px": 3, "parameters": [5, 6, 2, 1]},
       "cam_from_world": {"rotation_wxyz": [1, 0, 0, 0], "translation": [1, 2, 3]})";

Eye some_eye() {
    const Eigen::AngleAxisd turn(0.3, Eigen::Vector3d(1, 2, 3).normalized());
    return {{4, 3, LensModel::kPinhole, {5.1, 6.2, 2.3, 1.4}},
            {Eigen::Quaterniond(turn), Eigen::Vector3d(0.1, -0.2, 1.0 / 3)}};
}

/// What reading such a text ends in.
std::string said_of_file(const std::filesystem::path& file, const std::string& text) {
    write_whole_text(file, text);
    try {
        (void)read_eye_file(file);
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

TEST(EyeFile, TellsWhatTheWindowWroteBesideAScreenshot) {
    const ScratchFolder scratch;
    const Frame frame{ColorImage(4, 3), GrayImage(4, 3, 255), {}};
    for (const RenderMode mode : all_render_modes()) {
        for (const bool flag : {false, true}) {
            RenderOptions options;
            options.mode = mode;
            options.debug_picture = flag ? DebugPicture::kDepth : DebugPicture::kNone;
            options.correct_occlusion = flag;
            options.fade_beyond_capture = !flag;
            options.guess_surroundings = flag;
            write_screenshot(scratch / "shot.png", frame, some_eye(), options,
                             flag ? Exposures::kEvened : Exposures::kAsTaken, "box");
            const EyeFile read = read_eye_file(scratch / "shot.json");
            EXPECT_TRUE(is_same_eye(read.eye, some_eye()));
            EXPECT_EQ(read.drawn.mode, mode);
            EXPECT_EQ(read.drawn.debug_picture, options.debug_picture);
            EXPECT_EQ(read.drawn.correct_occlusion, flag);
            EXPECT_EQ(read.drawn.fade_beyond_capture, !flag);
            EXPECT_EQ(read.drawn.guess_surroundings, flag);
            EXPECT_EQ(read.drawn.as_taken, !flag);
        }
    }
}

TEST(EyeFile, AnEyeAndAPathAreToldApart) {
    const ScratchFolder scratch;
    const auto advice_on = [](const auto& read) -> std::string {
        try {
            (void)read();
        } catch (const Error& error) {
            return error.advice();
        }
        return "accepted";
    };
    write_whole_text(scratch / "eye.json", "{" + kEyeAlone + "}");
    write_whole_text(scratch / "path.json", R"({"eyes": [{)" + kEyeAlone + "}]}");
    EXPECT_THAT(advice_on([&] { return read_path_file(scratch / "eye.json", 1.0); }),
                HasSubstr("--eye"));
    EXPECT_THAT(advice_on([&] { return read_eye_file(scratch / "path.json"); }),
                HasSubstr("--path"));
}

TEST(EyeFile, MayBeAnEyeAlone) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "eye.json", "{" + kEyeAlone + ", \"note\": 3}");
    const EyeFile read = read_eye_file(scratch / "eye.json");
    EXPECT_EQ(read.eye.cam_from_world.translation, Eigen::Vector3d(1, 2, 3));
    EXPECT_FALSE(read.drawn.mode || read.drawn.debug_picture || read.drawn.as_taken);
}

TEST(EyeFile, WhatIsNoJsonIsSaidWithItsPlaceAndWithoutTheParsersNames) {
    const ScratchFolder scratch;
    const auto said_of = [&](const std::string& text) -> std::string {
        return said_of_file(scratch / "eye.json", text);
    };
    const std::string file = (scratch / "eye.json").string();
    EXPECT_THAT(said_of("{\n  \"camera\": 3,\n}"), StartsWith(file + ":3:1: unexpected '}'"));
    EXPECT_THAT(said_of(""), StartsWith(file + ":1:1: unexpected end of input"));
    EXPECT_EQ(said_of("{}"), file + ": key 'camera' not found");
    for (const char* wrong : {"{", "nul", "{}", "[1e999]", "{\"camera\": [3]}", "[]"})
        EXPECT_THAT(said_of(wrong), Not(HasSubstr("json.exception"))) << wrong;
}

TEST(EyeFile, NumbersAreAsManyAndAsWholeAsTheyMustBe) {
    const ScratchFolder scratch;
    const auto said_of = [&](const std::string& right, const std::string& wrong) -> std::string {
        std::string text = "{" + kEyeAlone + "}";
        text.replace(text.find(right), right.size(), wrong);
        return said_of_file(scratch / "eye.json", text);
    };
    EXPECT_EQ(said_of("[1, 2, 3]", "[1, 2, 3]"), "accepted");
    for (const std::string wrong : {"[1, 2]", "[1, 2, 3, 4]"})
        EXPECT_THAT(said_of("[1, 2, 3]", wrong), HasSubstr("translation: expected [x, y, z]"));
    EXPECT_THAT(said_of("[1, 0, 0, 0]", "[1, 0, 0]"),
                HasSubstr("rotation_wxyz: expected [w, x, y, z]"));
    EXPECT_THAT(said_of("\"width_px\": 4", "\"width_px\": 4.7"),
                HasSubstr("width_px: expected a whole number"));
    EXPECT_THAT(said_of("\"width_px\": 4", "\"width_px\": 4294967300"),
                HasSubstr("width_px: expected a whole number"));
}

std::string eye_of_path(const std::string& before = "") { return "{" + before + kEyeAlone + "}"; }

/// What reading a path of these eyes ends in.
std::string said_of_path(const std::string& eyes) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "path.json", R"({"eyes": [)" + eyes + "]}");
    try {
        (void)read_path_file(scratch / "path.json", 1.0);
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

TEST(PathFile, SaysWhichOfItsEyesIsWrong) {
    const std::string right = eye_of_path() + ",";
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string wrong = eye_of_path();
        wrong.replace(wrong.find(from), from.size(), to);
        return said_of_path(right + right + wrong);
    };
    EXPECT_EQ(said_of_path(right + eye_of_path()), "accepted");
    EXPECT_THAT(with("[1, 0, 0, 0]", "[1, 0, 0]"),
                HasSubstr("eyes[2].cam_from_world.rotation_wxyz: expected [w, x, y, z]"));
    EXPECT_THAT(with("[5, 6, 2, 1]", "[5]"),
                HasSubstr("eyes[2].camera.parameters: expected [fx, fy, cx, cy]"));
    EXPECT_THAT(with("[5, 6, 2, 1]", "[0, 6, 2, 1]"), HasSubstr("eyes[2].camera"));
    EXPECT_THAT(with("\"width_px\": 4", "\"width_px\": 8"), HasSubstr("eyes[2]: all must have"));
    EXPECT_THAT(with("\"camera\"", "\"Camera\""), HasSubstr("eyes[2]: unknown key `Camera`"));
    EXPECT_THAT(with("\"model\"", "\"Model\""), HasSubstr("eyes[2].camera: key 'model' not found"));
    EXPECT_THAT(
        said_of_path(R"({"time_s": 1, )" + kEyeAlone + R"(}, {"time_s": 0.5, )" + kEyeAlone + "}"),
        HasSubstr("eyes[1].time_s: expected seconds"));
    EXPECT_THAT(said_of_path(eye_of_path(R"("time_s": "1", )")), HasSubstr("eyes[0].time_s"));
    EXPECT_THAT(said_of_path(right + "3"), HasSubstr("eyes[1]"));
    EXPECT_THAT(said_of_path(""), HasSubstr("eyes: expected a list of eyes"));
}

TEST(PathFile, TakesNoMisspeltTimeForNone) {
    EXPECT_THAT(said_of_path(eye_of_path(R"("times": 0, )")),
                HasSubstr("eyes[0]: unknown key `times`"));
    EXPECT_EQ(said_of_path(eye_of_path(R"("time_s": 0, "lumigraph": "box", "mode": "adaptive", )")),
              "accepted")
        << "a screenshot's";
}

TEST(PathFile, BeginsWithItsFirstEye) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "path.json", R"({"eyes": [)" + eye_of_path(R"("time_s": 5, )") +
                                                "," + eye_of_path(R"("time_s": 6, )") + "," +
                                                eye_of_path(R"("time_s": 6, )") + "]}");
    const std::vector<TimedEye> path = read_path_file(scratch / "path.json", 1.0);
    ASSERT_EQ(path.size(), 3U);
    EXPECT_EQ(path[0].time_s, 0.0);
    EXPECT_EQ(path[1].time_s, 1.0);
    EXPECT_EQ(path[2].time_s, 1.0) << "a jump";
}

TEST(EyesOfAWindow, AreAScreenshotsOrAPaths) {
    const ScratchFolder scratch;
    write_screenshot(scratch / "lumi-0001.png", {ColorImage(4, 3), GrayImage(4, 3, 255), {}},
                     some_eye(), {}, Exposures::kEvened, "box");
    for (const char* name : {"lumi-0001.png", "lumi-0001.json"}) {
        const std::vector<TimedEye> eyes = read_eyes_of_window(scratch / name);
        ASSERT_EQ(eyes.size(), 1U) << name;
        EXPECT_TRUE(is_same_eye(eyes.front().eye, some_eye())) << name;
    }
    write_whole_text(scratch / "path.json",
                     R"({"eyes": [)" + eye_of_path() + "," + eye_of_path() + "]}");
    EXPECT_EQ(read_eyes_of_window(scratch / "path.json").size(), 2U);
    write_whole_text(scratch / "IMG_1.png", "a photograph");
    try {
        (void)read_eyes_of_window(scratch / "IMG_1.png");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("no IMG_1.json lies beside it"));
    }
}

TEST(EyeFile, AModeThatThereIsNoneOfIsRefusedByName) {
    const ScratchFolder scratch;
    for (const std::string wrong : {R"("mode": "photoreal")", R"("debug_picture": "mood")",
                                    R"("mode": 3)", R"("as_taken": "yes")"}) {
        write_whole_text(scratch / "eye.json", "{" + kEyeAlone + "," + wrong + "}");
        try {
            (void)read_eye_file(scratch / "eye.json");
            ADD_FAILURE() << wrong;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-JSON-READ") << wrong;
            EXPECT_THAT(error.what(), HasSubstr("eye.json")) << wrong;
        }
    }
}

}  // namespace
}  // namespace lumi
