#include "render/viewer/path_recording.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

Eye eye_from(double x, int width_px = 64) {
    Eye eye{{width_px, 48, LensModel::kPinhole, {60, 60, 0.5 * width_px, 24}}, {}};
    eye.cam_from_world.translation = {-x, 0, 0};
    return eye;
}

std::size_t eyes_in(const std::filesystem::path& file) {
    return nlohmann::json::parse(read_whole_text(file)).at("eyes").size();
}

TEST(PathRecording, WritesEachEyeThatDiffersFromTheOneBefore) {
    const ScratchFolder scratch;
    PathRecording recording;
    for (const double x : {0.0, 0.0, 0.1, 0.0}) recording.append(eye_from(x));
    EXPECT_EQ(recording.end(scratch.path()), "wrote lumi-path-0001.json");
    EXPECT_EQ(eyes_in(scratch / "lumi-path-0001.json"), 3U);
}

TEST(PathRecording, LeavesOutEyesOfAnotherSizeThanTheFirst) {
    const ScratchFolder scratch;
    PathRecording recording;
    recording.append(eye_from(0.0));
    EXPECT_EQ(recording.append(eye_from(0.1, 80)), "recording: 1 eyes");
    recording.append(eye_from(0.2));
    recording.end(scratch.path());
    EXPECT_EQ(eyes_in(scratch / "lumi-path-0001.json"), 2U);
}

TEST(PathRecording, BeginsAnewOnceItHasEnded) {
    const ScratchFolder scratch;
    PathRecording recording;
    EXPECT_EQ(recording.end(scratch.path()), "");
    recording.append(eye_from(0.0));
    recording.end(scratch.path());
    EXPECT_EQ(recording.end(scratch.path()), "");
    recording.append(eye_from(0.1, 80));
    EXPECT_EQ(recording.end(scratch.path()), "wrote lumi-path-0002.json");
}

TEST(PathRecording, SaysWhatCannotBeWritten) {
    const ScratchFolder scratch;
    PathRecording recording;
    recording.append(eye_from(0.0));
    write_whole_text(scratch / "a file", "");
    EXPECT_NE(recording.end(scratch / "a file").find("a file"), std::string::npos);
}

}  // namespace
}  // namespace lumi
