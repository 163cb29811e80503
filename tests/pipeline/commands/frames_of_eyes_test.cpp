#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "calib/ingest/made_by_lumi.h"
#include "calib/pictures/image_io.h"
#include "calib/work/whole_file.h"
#include "tests/pipeline/box_line.h"
#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kEye =
    R"({"camera": {"model": "PINHOLE", "width_px": 64, "height_px": 48,
                   "parameters": [60, 60, 32, 24]},
        "cam_from_world": {"rotation_wxyz": [1, 0, 0, 0], "translation": [0, 0, 0]}})";

std::string eye_at_time(const std::string& time_s) {
    return R"({"time_s": )" + time_s + "," + std::string(kEye).substr(1);
}

std::ptrdiff_t frames_in(const fs::path& folder) {
    return std::count_if(fs::directory_iterator(folder), {}, [](const fs::directory_entry& entry) {
        return entry.path().extension() == ".png";
    });
}

/// A package, and frames of it from eyes in files.
class FramesOfEyes : public BoxLine {
 protected:
    void SetUp() override {
        configure("");
        ASSERT_EQ(build(), "rrrrr");
        write_whole_text(scratch_ / "eye.json", kEye);
    }
    Outcome draw(const std::string& arguments, const fs::path& out) const {
        return lumi("render " + quoted(package()) + " " + arguments + " --out " + quoted(out));
    }
    [[nodiscard]] ColorImage still(const std::string& more = "") const {
        const fs::path out = scratch_ / "still.png";
        EXPECT_EQ(draw("--eye " + quoted(scratch_ / "eye.json") + more, out).exit_code, 0);
        return read_color_image(out);
    }
    Outcome fly(const std::string& eyes, const fs::path& out, const std::string& more = "") const {
        write_whole_text(scratch_ / "path.json", R"({"eyes": [)" + eyes + "]}");
        return draw("--path " + quoted(scratch_ / "path.json") + more, out);
    }
};

TEST_F(FramesOfEyes, GoFromPhotographToPhotograph) {
    const fs::path frames = scratch_ / "frames";
    ASSERT_EQ(draw("--size 96x64 --path views --frames 3", frames).exit_code, 0);
    EXPECT_EQ(frames_in(frames), 3);
    EXPECT_TRUE(is_made_by_lumi(frames)) << "no photographs for the next build";
    EXPECT_EQ(draw("--size 96x64 --path views --frames 2", frames).exit_code, 0);
    EXPECT_EQ(frames_in(frames), 2);
    EXPECT_EQ(read_color_image(frames / "frame-000001.png").width(), 96);
    ASSERT_EQ(draw("--size 48x32 --path views --mode lightfield --video-fps 3", frames).exit_code,
              0);
    EXPECT_EQ(frames_in(frames), 16) << "two thirds of a second for each of eight steps";
}

TEST_F(FramesOfEyes, MakeAVideo) {
    const fs::path video = scratch_ / "tour.mp4";
    const Outcome outcome = draw("--size 96x64 --path views --frames 3", video);
    if (outcome.talk.find("E-CHILD-MISSING") != std::string::npos)
        GTEST_SKIP() << "neither ffmpeg nor ffprobe here: " << outcome.talk;
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    EXPECT_EQ(read_whole_text(video).substr(4, 4), "ftyp");
}

TEST_F(FramesOfEyes, AlongAPathAreThoseOfItsEyes) {
    const fs::path flown = scratch_ / "flown";
    ASSERT_EQ(fly(std::string(kEye) + "," + kEye, flown).exit_code, 0);
    EXPECT_EQ(read_color_image(flown / "frame-000002.png"), still());
    EXPECT_EQ(fly("", flown).exit_code, 3) << "a path without an eye";
}

TEST_F(FramesOfEyes, FlyAsFastAsThePathWasRecorded) {
    const fs::path flown = scratch_ / "flown";
    const std::string eyes = eye_at_time("0") + "," + eye_at_time("1.5");
    ASSERT_EQ(fly(eyes, flown, " --video-fps 4").exit_code, 0);
    EXPECT_EQ(frames_in(flown), 7);
}

TEST_F(FramesOfEyes, AreTheSameAsTakenWherePhotographsDifferInNothingThatCouldBeEvened) {
    EXPECT_EQ(still(" --as-taken --no-fade"), still());
}

TEST_F(FramesOfEyes, MakeAPairSideBySide) { EXPECT_EQ(still(" --stereo 0.1").width(), 128); }

TEST_F(FramesOfEyes, NeedNoMoreThanThePackage) {
    const std::string packed = "--view IMG_0001.png";
    const std::string unknown = "--view nobody.png";
    const fs::path out = scratch_ / "frame.png";
    write_whole_text(workspace() / "pack" / "pack.json", "damaged");
    EXPECT_EQ(draw(packed, out).exit_code, 0);
    EXPECT_EQ(draw("--all-views --mode lightfield", scratch_ / "all").exit_code, 0);
    EXPECT_THAT(draw("--all-views --mode lightfield", scratch_ / "all").talk,
                HasSubstr("pack.json"))
        << "what stands there may have been held out";
    EXPECT_THAT(draw(unknown, out).talk, HasSubstr("pack.json")) << "it may have been held out";
    fs::remove(workspace() / "config.toml");
    EXPECT_EQ(draw(packed, out).exit_code, 0);
    EXPECT_THAT(draw(unknown, out).talk, HasSubstr("E-RENDER-VIEW"));
}

TEST_F(FramesOfEyes, OfDifferentKindsReplaceNoOthers) {
    const fs::path all = scratch_ / "all";
    const std::string views = "--all-views --mode lightfield";
    for (const char* kind : {"", " --difference", " --debug weights"})
        EXPECT_EQ(draw(views + kind, all).exit_code, 0) << kind;
    EXPECT_EQ(frames_in(all), 3 * 9);
    EXPECT_TRUE(fs::exists(all / "IMG_0001.lightfield.difference.png"));
    EXPECT_TRUE(fs::exists(all / "IMG_0001.lightfield.weights.png"));
}

}  // namespace
}  // namespace lumi
