#include <gmock/gmock.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "calib/ingest/ingest.h"
#include "calib/ingest/video_colors.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

/// Two seconds at 10 frames a second; every frame is blurred but numbers 4 and 13.
void write_video(const std::filesystem::path& path, int width = 320, int height = 240) {
    cv::VideoWriter writer(path.string(), cv::CAP_OPENCV_MJPEG,
                           cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10.0, {width, height});
    ASSERT_TRUE(writer.isOpened());
    for (int number = 1; number <= 20; ++number) {
        ColorImage picture = wavy_picture(width, height, 3.0 * number);
        cv::Mat frame(height, width, CV_8UC3, picture.row(0));
        cv::cvtColor(frame, frame, cv::COLOR_RGB2BGR);
        if (number != 4 && number != 13) cv::GaussianBlur(frame, frame, {}, 3.0);
        writer.write(frame);
    }
}

TEST(Video, GivesTheSharpestFrameOfEachInterval) {
    const ScratchFolder scratch;
    write_video(scratch / "walk.avi");
    SilentProgress progress;
    const IngestResult result =
        ingest(scratch / "walk.avi", {.video_fps = 1.0}, scratch / "copies", 1, progress);
    ASSERT_EQ(result.photographs.size(), 2U);
    EXPECT_EQ(result.photographs[0].name, "frame-000004.png");
    EXPECT_EQ(result.photographs[1].name, "frame-000013.png");
    EXPECT_EQ(result.photographs[0].camera_key, result.photographs[1].camera_key);
    const ColorImage copy = read_color_image(result.photographs[1].picture_path);
    EXPECT_EQ(copy.width(), 320);
    // MJPEG at its default quality differs from what was written by a few levels.
    const ColorImage written = wavy_picture(320, 240, 3.0 * 13);
    double difference = 0;
    for (std::size_t i = 0; i < copy.pixels().size(); ++i) {
        difference += std::abs(copy.pixels()[i].g - written.pixels()[i].g);
    }
    EXPECT_LT(difference / static_cast<double>(copy.pixels().size()), 3.0);
}

TEST(Video, LeavesOutTinyFrames) {
    const ScratchFolder scratch;
    write_video(scratch / "stamp.avi", 64, 48);
    SilentProgress progress;
    const auto ingested_with = [&](const IngestOptions& options) {
        return ingest(scratch / "stamp.avi", options, scratch / "copies", 1, progress);
    };
    try {
        static_cast<void>(ingested_with({.video_fps = 1.0}));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-INGEST-TOOFEW");
        EXPECT_THAT(error.what(), testing::HasSubstr("frame-000004.png: 64x48 pixels"));
    }
    EXPECT_EQ(ingested_with({.min_width_px = 48, .video_fps = 1.0}).photographs.size(), 2U);
}

/// Behind a video of its own, as a movie header that says what colours mean and nothing else.
void append_colors(const std::filesystem::path& path, std::uint8_t primaries,
                   std::uint8_t transfer) {
    const Bytes video = read_whole_file(path);
    Bytes colors{0,   0,   0,   26,  'm', 'o', 'o', 'v', 0,         0, 0,        18, 'c',
                 'o', 'l', 'r', 'n', 'c', 'l', 'c', 0,   primaries, 0, transfer, 0,  9};
    colors.insert(colors.begin(), video.begin(), video.end());
    std::filesystem::remove(path);
    write_whole_file(path, colors);
}

void write_mp4(const std::filesystem::path& path) {
    cv::VideoWriter writer(path.string(), cv::CAP_FFMPEG,
                           cv::VideoWriter::fourcc('m', 'p', '4', 'v'), 10.0, {320, 240});
    ASSERT_TRUE(writer.isOpened());
    const cv::Mat green(240, 320, CV_8UC3, cv::Scalar(60, 180, 60));
    for (int number = 1; number <= 20; ++number) writer.write(green);
}

TEST(Video, HlgBecomesSrgbAndSaysSo) {
    const ScratchFolder scratch;
    write_mp4(scratch / "walk.mp4");
    SilentProgress progress;
    EXPECT_FALSE(coded_colors_of_video(scratch / "walk.mp4").has_value());
    const auto green_of = [&](const std::string& copies) {
        const IngestResult result =
            ingest(scratch / "walk.mp4", {.min_photographs = 1, .video_fps = 1.0}, scratch / copies,
                   1, progress);
        return std::pair(read_color_image(result.photographs.at(0).picture_path)(100, 100),
                         result.color_notes);
    };
    const auto [plain, no_notes] = green_of("plain");
    EXPECT_THAT(no_notes, testing::IsEmpty());
    append_colors(scratch / "walk.mp4", 9, 18);
    const auto [shown, notes] = green_of("hlg");
    // The green of BT.2020 is wider: the same numbers are a stronger green.
    EXPECT_LT(shown.r, plain.r - 10);
    EXPECT_GE(shown.g, plain.g);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0], testing::HasSubstr("HLG (BT.2020)"));
}

TEST(Video, PqIsRefusedWithAWayOut) {
    const ScratchFolder scratch;
    write_mp4(scratch / "walk.mp4");
    append_colors(scratch / "walk.mp4", 9, 16);
    SilentProgress progress;
    try {
        static_cast<void>(ingest(scratch / "walk.mp4", {}, scratch / "copies", 1, progress));
        FAIL() << "nothing thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-INGEST-HDR");
        EXPECT_THAT(error.advice(), testing::HasSubstr("ffmpeg"));
    }
}

TEST(Video, RefusesAFileThatIsNone) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "notes.txt", "not a video");
    SilentProgress progress;
    try {
        static_cast<void>(ingest(scratch / "notes.txt", {}, scratch / "copies", 1, progress));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-INGEST-NOVIDEO");
    }
}

}  // namespace
}  // namespace lumi
