#include "render/viewer/path_recording.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

Eye eye_from(double x) {
    Eye eye{{64, 48, LensModel::kPinhole, {60, 60, 32, 24}}, {}};
    eye.cam_from_world.translation = {-x, 0, 0};
    return eye;
}

/// As a window of 64 x 48 shows it.
std::string append_to(PathRecording& recording, double x, double clock_s) {
    return recording.append(eye_from(x), 64, 48, clock_s);
}

std::vector<double> times_in(const std::filesystem::path& file) {
    std::vector<double> times_s;
    const nlohmann::json json = nlohmann::json::parse(read_whole_text(file));
    for (const nlohmann::json& eye : json.at("eyes")) times_s.push_back(eye.at("time_s"));
    return times_s;
}

TEST(PathRecording, WritesEachEyeWithItsTimeAndOfARestTheBeginningAndTheEnd) {
    const ScratchFolder scratch;
    PathRecording recording;
    double clock_s = 100.0;
    for (const double x : {0.0, 0.0, 0.0, 0.0, 0.1, 0.0}) append_to(recording, x, clock_s += 0.5);
    EXPECT_EQ(recording.end(scratch.path()),
              "wrote " + (scratch / "lumi-path-0001.json").string() + ": 4 eyes, 2.5 s");
    EXPECT_EQ(times_in(scratch / "lumi-path-0001.json"), (std::vector{0.0, 1.5, 2.0, 2.5}));
}

TEST(PathRecording, DoesNotLetTheEyeCreepWhereItRested) {
    PathRecording recording;
    for (int i = 0; i <= 10; ++i) append_to(recording, 0.0, i);
    append_to(recording, 1.0, 11.0);
    const Eye rested = eye_at_time(recording.path(), 7.3);
    EXPECT_LT(centre_in_world(rested.cam_from_world).norm(), 1e-12);
}

TEST(PathRecording, DoesNotFlyWhereTheEyeJumped) {
    PathRecording recording;
    append_to(recording, 0.0, 0.0);
    append_to(recording, 0.1, 1.0);
    recording.append(eye_from(7.0), 64, 48, 1.5, true);
    append_to(recording, 7.1, 2.0);
    const auto x_at = [&](double time_s) {
        return centre_in_world(eye_at_time(recording.path(), time_s).cam_from_world).x();
    };
    EXPECT_NEAR(x_at(0.5), 0.05, 1e-12);
    for (const double time_s : {1.0, 1.2, 1.499}) EXPECT_NEAR(x_at(time_s), 0.1, 1e-12) << time_s;
    EXPECT_NEAR(x_at(1.501), 7.0, 1e-3);
    EXPECT_NEAR(x_at(1.75), 7.05, 1e-12);
}

TEST(PathRecording, GoesOnInTheSizeOfItsBeginningWhenTheWindowIsResized) {
    PathRecording recording;
    EXPECT_EQ(append_to(recording, 0.0, 0.0), "recording: 1 eye, 0.0 s");
    EXPECT_EQ(recording.append(eye_from(0.1), 80, 90, 0.5),
              "recording: 2 eyes, 0.5 s, in the size of its beginning: 64 x 48");
    append_to(recording, 0.2, 1.0);
    ASSERT_EQ(recording.path().size(), 3U);
    for (const TimedEye& timed : recording.path()) EXPECT_EQ(timed.eye.camera, eye_from(0).camera);
}

TEST(PathRecording, BeginsAnewOnceItHasEnded) {
    const ScratchFolder scratch;
    PathRecording recording;
    EXPECT_EQ(recording.end(scratch.path()), "");
    append_to(recording, 0.0, 7.0);
    recording.end(scratch.path());
    EXPECT_EQ(recording.end(scratch.path()), "");
    EXPECT_EQ(recording.path().size(), 1U) << "to be replayed";
    recording.append(eye_from(0.1), 80, 48, 9.0);
    EXPECT_EQ(recording.end(scratch.path()),
              "wrote " + (scratch / "lumi-path-0002.json").string() + ": 1 eye, 0.0 s");
    EXPECT_EQ(recording.path().front().eye.camera.width_px, 80);
}

TEST(PathRecording, SaysWhatCannotBeWritten) {
    const ScratchFolder scratch;
    PathRecording recording;
    append_to(recording, 0.0, 0.0);
    write_whole_text(scratch / "a file", "");
    const std::string words = recording.end(scratch / "a file");
    EXPECT_NE(words.find("a file"), std::string::npos) << words;
    EXPECT_NE(words.find(" - check that"), std::string::npos) << words << ": what to do about it";
}

TEST(PathRecording, CanBeWrittenAgainWhereItCouldNotBe) {
    const ScratchFolder scratch;
    PathRecording recording;
    append_to(recording, 0.0, 0.0);
    append_to(recording, 0.1, 0.5);
    EXPECT_FALSE(recording.is_unwritten()) << "it goes on";
    write_whole_text(scratch / "a file", "");
    EXPECT_NE(recording.end(scratch / "a file"), "");
    EXPECT_TRUE(recording.is_unwritten());
    EXPECT_NE(recording.end(scratch.path()), "");
    EXPECT_FALSE(recording.is_unwritten());
    EXPECT_EQ(times_in(scratch / "lumi-path-0001.json"), (std::vector{0.0, 0.5}));
    EXPECT_EQ(recording.end(scratch.path()), "");
}

}  // namespace
}  // namespace lumi
