#include "pipeline/commands/video_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "calib/pictures/image_io.h"
#include "calib/work/child_process.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/commands/frame_files.h"
#include "tests/calib/noted_progress.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr Rgb8 kOrange{183, 105, 32};

/// Videos, and what a player shows of them.
class VideoFile : public testing::Test {
 protected:
    void SetUp() override {
        try {
            check_video_programs(scratch_ / "film.mp4", progress_);
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
    }
    /// Of three frames that are all this picture.
    fs::path film_of(const ColorImage& picture) {
        const fs::path film = scratch_ / "film.mp4";
        WholeFolder frames(frames_folder_of_video(film));
        for (std::size_t i = 0; i < 3; ++i)
            write_png(frames.staging() / sequence_frame_name(i), picture);
        write_video(frames, 3, 30.0, film, progress_);
        return film;
    }
    /// The first frame by BT.709, as players take what says nothing.
    ColorImage shown(const fs::path& film) {
        const fs::path frame = scratch_ / "shown.png";
        run({"ffmpeg", "-y", "-loglevel", "error", "-i", film.string(), "-vf",
             "scale=in_color_matrix=bt709:in_range=tv,format=rgb24", "-frames:v", "1",
             frame.string()});
        return read_color_image(frame);
    }
    std::string run(const std::vector<std::string>& arguments) {
        const fs::path log = scratch_ / "log";
        ChildCommand command;
        command.arguments = arguments;
        command.log_path = log;
        const ChildResult result = run_child(command, progress_);
        const std::string output = read_whole_text(log);
        EXPECT_EQ(result.exit_status, 0) << output;
        return output;
    }

    ScratchFolder scratch_;
    NotedProgress progress_;
};

/// The largest difference of a channel from what every pixel should be.
int largest_difference(const ColorImage& picture, const Rgb8& expected) {
    int largest = 0;
    for (const Rgb8& pixel : picture.pixels())
        largest = std::max({largest, std::abs(pixel.r - expected.r), std::abs(pixel.g - expected.g),
                            std::abs(pixel.b - expected.b)});
    return largest;
}

TEST_F(VideoFile, ShowsTheColorsOfItsFramesAndSaysHowTheyAreCoded) {
    const fs::path film = film_of(ColorImage(64, 48, kOrange));
    EXPECT_LE(largest_difference(shown(film), kOrange), 3);
    EXPECT_EQ(run({"ffprobe", "-v", "error", "-show_entries",
                   "stream=pix_fmt,color_range,color_space,color_transfer,color_primaries", "-of",
                   "csv=p=0", film.string()}),
              "yuv420p,tv,bt709,iec61966-2-1,bt709\n");
}

TEST_F(VideoFile, OfOddSizeHasNoDarkEdgesAndItsLastColorsAreTrue) {
    for (const auto& [width, height] : {std::pair{33, 17}, {34, 17}, {33, 18}, {1, 1}}) {
        const ColorImage frame = shown(film_of(ColorImage(width, height, kOrange)));
        EXPECT_EQ(frame.width(), width + width % 2);
        EXPECT_EQ(frame.height(), height + height % 2);
        EXPECT_LE(largest_difference(frame, kOrange), 3) << width << " x " << height;
    }
}

}  // namespace
}  // namespace lumi
