#include <gmock/gmock.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "calib/ingest/ingest.h"
#include "calib/pictures/image_io.h"
#include "calib/work/child_process.h"
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
        EXPECT_THAT(error.what(), testing::HasSubstr("0 usable frames"));
        EXPECT_THAT(error.what(), testing::HasSubstr("frame-000004.png: 64x48 pixels"));
        EXPECT_THAT(error.advice(), testing::HasSubstr("video_fps (1 frames a second are kept)"));
    }
    EXPECT_EQ(ingested_with({.min_width_px = 48, .video_fps = 1.0}).photographs.size(), 2U);
}

void run(const std::vector<std::string>& arguments) {
    ChildCommand command;
    command.arguments = arguments;
    command.log_path = arguments.back() + ".log";
    ASSERT_EQ(run_child(command, SilentProgress()).exit_status, 0);
}

constexpr Rgb8 kGreen{20, 180, 40};

/// Two seconds of green by the program ffmpeg, coded by the matrix of this name and tagged so.
void write_green(const std::filesystem::path& path, const std::string& matrix,
                 const std::vector<std::string>& tags, const std::string& size = "320x240") {
    std::vector<std::string> arguments{"ffmpeg",
                                       "-y",
                                       "-f",
                                       "lavfi",
                                       "-i",
                                       "color=c=0x14B428:s=" + size +
                                           ":r=10:d=2,scale=out_color_matrix=" + matrix +
                                           ":out_range=tv,format=yuv420p",
                                       "-c:v",
                                       "libx264",
                                       "-qp",
                                       "4"};
    arguments.insert(arguments.end(), tags.begin(), tags.end());
    arguments.push_back(path.string());
    ASSERT_NO_FATAL_FAILURE(run(arguments));
}

std::vector<std::string> tags_of(const std::string& matrix, const std::string& primaries,
                                 const std::string& transfer) {
    return {"-colorspace", matrix,   "-color_primaries", primaries,
            "-color_trc",  transfer, "-color_range",     "tv"};
}

struct Ingested {
    Rgb8 color;
    std::vector<std::string> notes;
    std::string reasons;  ///< Of what was left out.
};

Ingested ingested(const std::filesystem::path& video, const std::filesystem::path& copies) {
    SilentProgress progress;
    const IngestResult result =
        ingest(video, {.min_photographs = 1, .video_fps = 1.0}, copies, 1, progress);
    Ingested found{read_color_image(result.photographs.at(0).picture_path)(100, 100),
                   result.color_notes, ""};
    for (const LeftOut& left_out : result.left_out) {
        found.reasons += left_out.code + ": " + left_out.reason + "\n";
    }
    return found;
}

/// To what coding in 8 bits and H.264 leave; the other matrix is 24 levels off.
void expect_color(Rgb8 found, Rgb8 expected) {
    EXPECT_NEAR(found.r, expected.r, 4);
    EXPECT_NEAR(found.g, expected.g, 4);
    EXPECT_NEAR(found.b, expected.b, 4);
}

TEST(Video, ColoursAreDecodedByTheMatrixThatTheVideoNames) {
    const ScratchFolder scratch;
    for (const std::string matrix : {"bt709", "smpte170m"}) {
        const auto tags = tags_of(matrix, "bt709", "bt709");
        for (const std::string ending : {".mp4", ".mkv"}) {
            write_green(scratch / (matrix + ending), matrix, tags);
            const Ingested found = ingested(scratch / (matrix + ending), scratch / "copies");
            expect_color(found.color, kGreen);
            EXPECT_THAT(found.notes, testing::IsEmpty());
        }
    }
}

TEST(Video, ColoursWithoutAMatrixAreThoseOfPlayers) {
    const ScratchFolder scratch;
    write_green(scratch / "small.mp4", "smpte170m", {});
    expect_color(ingested(scratch / "small.mp4", scratch / "copies").color, kGreen);
    write_green(scratch / "large.mp4", "bt709", {}, "1280x720");
    expect_color(ingested(scratch / "large.mp4", scratch / "copies").color, kGreen);
}

TEST(Video, HlgBecomesSrgbAndSaysSo) {
    const ScratchFolder scratch;
    write_green(scratch / "walk.mp4", "bt2020nc", tags_of("bt2020nc", "bt2020", "arib-std-b67"));
    const Ingested found = ingested(scratch / "walk.mp4", scratch / "copies");
    // The green of BT.2020 is wider: the same numbers are a stronger green.
    EXPECT_LT(found.color.r, kGreen.r - 10);
    EXPECT_GE(found.color.g, kGreen.g);
    ASSERT_EQ(found.notes.size(), 1U);
    EXPECT_THAT(found.notes[0], testing::HasSubstr("HLG (BT.2020)"));
}

TEST(Video, PqIsRefusedInAnyContainerWithAWayOut) {
    const ScratchFolder scratch;
    for (const std::string name : {"walk.mp4", "walk.mkv"}) {
        write_green(scratch / name, "bt2020nc", tags_of("bt2020nc", "bt2020", "smpte2084"));
        SilentProgress progress;
        try {
            static_cast<void>(ingest(scratch / name, {}, scratch / "copies", 1, progress));
            FAIL() << "nothing thrown";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-INGEST-HDR");
            EXPECT_THAT(error.advice(), testing::HasSubstr("ffmpeg"));
        }
    }
}

/// As of DV and HDV tapes: 4:3 or 16:9 in a raster of another shape.
TEST(Video, WhosePixelsAreNotSquareIsStretchedUntilTheyAre) {
    const ScratchFolder scratch;
    for (const auto& [ratio, width_px, height_px] :
         {std::tuple("4/3", 427, 240), std::tuple("8/9", 320, 270)}) {
        write_green(scratch / "tape.mp4", "smpte170m", {"-vf", "setsar=" + std::string(ratio)});
        SilentProgress progress;
        const IngestResult result =
            ingest(scratch / "tape.mp4", {.min_photographs = 1}, scratch / "copies", 1, progress);
        const ColorImage copy = read_color_image(result.photographs.at(0).picture_path);
        EXPECT_EQ(copy.width(), width_px) << ratio;
        EXPECT_EQ(copy.height(), height_px) << ratio;
        expect_color(copy(copy.width() - 1, copy.height() - 1), kGreen);
    }
}

/// As where a picture's shape was rounded to that of a screen.
TEST(Video, WhosePixelsAreAllButSquareKeepsThem) {
    const ScratchFolder scratch;
    write_green(scratch / "screen.mp4", "smpte170m", {"-vf", "setsar=240/239:max=1000"});
    SilentProgress progress;
    const IngestResult result =
        ingest(scratch / "screen.mp4", {.min_photographs = 1}, scratch / "copies", 1, progress);
    EXPECT_EQ(result.photographs.at(0).width_px, 320);
    EXPECT_EQ(result.photographs.at(0).height_px, 240);
}

TEST(Video, ThatIsTurnedForDisplayKeepsItsRasterAndSaysSo) {
    const ScratchFolder scratch;
    write_green(scratch / "walk.mp4", "bt709", {});
    run({"ffmpeg", "-y", "-i", (scratch / "walk.mp4").string(), "-c", "copy", "-metadata:s:v",
         "rotate=270", (scratch / "turned.mp4").string()});
    SilentProgress progress;
    const IngestResult result =
        ingest(scratch / "turned.mp4", {.min_photographs = 1}, scratch / "copies", 1, progress);
    EXPECT_EQ(result.photographs.at(0).exif_orientation, 6);
    EXPECT_EQ(result.photographs.at(0).width_px, 320);
}

TEST(Video, ThatWasTrimmedIsWholeAndOneThatWasCutOffIsNot) {
    const ScratchFolder scratch;
    write_green(scratch / "whole.mp4", "bt709", {"-movflags", "+faststart"});
    run({"ffmpeg", "-y", "-ss", "1", "-i", (scratch / "whole.mp4").string(), "-c", "copy",
         (scratch / "trimmed.mp4").string()});
    for (const std::string name : {"whole.mp4", "trimmed.mp4"}) {
        EXPECT_THAT(ingested(scratch / name, scratch / "copies").reasons,
                    testing::Not(testing::HasSubstr("E-INGEST-TRUNCATED")));
    }
    write_video(scratch / "walk.avi");
    Bytes bytes = read_whole_file(scratch / "walk.avi");
    bytes.resize(bytes.size() / 2);
    write_whole_file(scratch / "cut.avi", bytes);
    EXPECT_THAT(ingested(scratch / "cut.avi", scratch / "copies").reasons,
                testing::HasSubstr("E-INGEST-TRUNCATED: the video ends after 0.9 of 2.0 seconds"));
}

TEST(Video, RefusesAFileThatIsNone) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "notes.txt", "not a video");
    write_png(scratch / "photograph.png", wavy_picture(320, 240));
    SilentProgress progress;
    for (const std::string name : {"notes.txt", "photograph.png"}) {
        try {
            static_cast<void>(ingest(scratch / name, {}, scratch / "copies", 1, progress));
            FAIL() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-INGEST-NOVIDEO") << name;
        }
    }
}

}  // namespace
}  // namespace lumi
