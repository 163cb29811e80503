#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/image_io.h"
#include "calib/work/whole_file.h"
#include "tests/pipeline/box_line.h"
#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::AllOf;
using testing::HasSubstr;

class RenderCommand : public BoxLine {};

/// Of one channel, over the pixels from `left` on that the smaller picture has.
double mean_difference(const ColorImage& wide, int left, const ColorImage& narrow) {
    double sum = 0;
    for (int y = 0; y < narrow.height(); ++y)
        for (int x = 0; x < narrow.width(); ++x)
            sum += std::abs(wide(left + x, y).g - narrow(x, y).g);
    return sum / static_cast<double>(narrow.pixels().size());
}

TEST_F(RenderCommand, DrawsAnyShapeOfFrameWithoutStretchingWhatItShows) {
    configure("");
    static_cast<void>(build());
    const fs::path drawn = workspace() / "drawn.png";
    const auto draw = [&](const std::string& arguments) {
        const std::string to = " --out " + quoted(drawn);
        EXPECT_EQ(lumi("render " + quoted(package()) + " " + arguments + to).exit_code, 0);
        return read_color_image(drawn);
    };
    const std::string view = "--view IMG_0005.png ";
    const ColorImage still = draw(view);
    ASSERT_EQ(still.width(), 160);
    const ColorImage wide = draw(view + "--size 240x120");
    ASSERT_EQ(wide.width(), 240);
    ASSERT_EQ(wide.height(), 120);
    EXPECT_LT(mean_difference(wide, 40, still), 2);

    const std::string eye =
        R"({"camera": {"model": "PINHOLE", "width_px": 64, "height_px": 48,
                       "parameters": [60, 60, 32, 24]},
            "cam_from_world": {"rotation_wxyz": [1, 0, 0, 0], "translation": [0, 0, 0]}})";
    const fs::path path = workspace() / "path.json";
    const fs::path frames = workspace() / "frames";
    write_whole_text(path, R"({"eyes": [)" + eye + "]}");
    ASSERT_EQ(lumi("render " + quoted(package()) + " --size 32x30 --path " + quoted(path) +
                   " --out " + quoted(frames))
                  .exit_code,
              0);
    const ColorImage frame = read_color_image(frames / "frame-000001.png");
    EXPECT_EQ(frame.width(), 32);
    EXPECT_EQ(frame.height(), 30);
}

TEST_F(RenderCommand, DrawsTheDifferenceFromAHeldOutPhotograph) {
    configure("[evaluate]\nhold_out = [\"IMG_0005.png\"]\n");
    static_cast<void>(build());
    const std::string at_held_out = "render " + quoted(package()) + " --view IMG_0005.png ";
    const fs::path drawn = workspace() / "drawn.png";
    const fs::path difference = workspace() / "difference.png";
    ASSERT_EQ(lumi(at_held_out + "--out " + quoted(drawn)).exit_code, 0);
    const Outcome outcome = lumi(at_held_out + "--json --difference --out " + quoted(difference));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const double said_db = Json::parse(outcome.out).at("frames").at(0).at("psnr_db").get<double>();
    EXPECT_GT(said_db, 15);

    // Steps that are four times as bright say what the plain picture's error is, where they fit.
    const ColorImage picture = read_color_image(drawn);
    const ColorImage error = read_color_image(difference);
    const ColorImage photograph = read_color_image(scene_->path() / "photos" / "IMG_0005.png");
    ASSERT_EQ(error.width(), picture.width());
    ASSERT_EQ(photograph.width(), picture.width());
    for (std::size_t i = 0; i < error.pixels().size(); ++i)
        ASSERT_EQ(error.pixels()[i].g,
                  std::min(255, 4 * std::abs(picture.pixels()[i].g - photograph.pixels()[i].g)));
    EXPECT_NEAR(Json::parse(lumi("compare-pictures --json " + quoted(drawn) + " " +
                                 quoted(scene_->path() / "photos" / "IMG_0005.png"))
                                .out)
                    .at("psnr_db")
                    .get<double>(),
                said_db, 1e-9);

    EXPECT_EQ(lumi(at_held_out + "--difference --size 96x64 --out " + quoted(difference)).exit_code,
              2);
    EXPECT_EQ(lumi(at_held_out + "--out " + quoted(workspace() / "drawn.jpg")).exit_code, 2);
    const Outcome unknown =
        lumi("render " + quoted(package()) + " --view nobody.png --out " + quoted(drawn));
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.talk, AllOf(HasSubstr("E-RENDER-VIEW"), HasSubstr("IMG_0001.png")));

    // By their names alone, as `lumi view` knows them.
    for (const char* name : {"IMG_0005", "IMG_0001"})
        EXPECT_EQ(
            lumi("render " + quoted(package()) + " --view " + name + " --out " + quoted(drawn))
                .exit_code,
            0)
            << name;
}

/// The photographs of the box in two folders, the fifth named like the first.
void part_into_folders(const fs::path& scene, const fs::path& parted) {
    Capture capture = read_colmap_model(scene / "truth" / "sparse");
    for (std::size_t i = 0; i < capture.views.size(); ++i) {
        std::string& name = capture.views[i].name;
        const fs::path photograph = scene / "photos" / name;
        name = i == 4 ? "right/" + capture.views[0].name.substr(5) : "left/" + name;
        fs::create_directories((parted / "photos" / name).parent_path());
        fs::copy_file(photograph, parted / "photos" / name);
    }
    write_colmap_model_binary(capture, parted / "sparse");
}

TEST_F(RenderCommand, ANameOfTwoPhotographsIsRefusedThoughOneOfThemWasHeldOut) {
    part_into_folders(scene_->path(), scratch_ / "parted");
    write_whole_text(config_path(),
                     "name = \"box\"\n[capture]\nphotos = \"parted/photos\"\n"
                     "import = \"parted/sparse\"\n"
                     "[evaluate]\nhold_out = [\"right/IMG_0001.png\"]\n" +
                         std::string(kSparseDepth) + kToldDrawing);
    ASSERT_EQ(build(), "rrrrr");
    const auto difference_at = [&](const std::string& name) {
        return lumi("--json render " + quoted(package()) + " --difference --view " + name +
                    " --out " + quoted(scratch_ / "error.png"));
    };
    const Outcome either = difference_at("IMG_0001");
    EXPECT_EQ(either.exit_code, 2);
    EXPECT_THAT(either.talk, AllOf(HasSubstr("E-RENDER-VIEW"), HasSubstr("left/IMG_0001.png")));
    const auto is_held_out = [&](const std::string& name) {
        return Json::parse(difference_at(name).out).at("frames").at(0).at("is_held_out");
    };
    EXPECT_EQ(is_held_out("right/IMG_0001.png"), true);
    EXPECT_EQ(is_held_out("left/IMG_0001.png"), false);
    EXPECT_EQ(is_held_out("IMG_0002"), false);
}

TEST_F(RenderCommand, FramesReplaceNothingButFrames) {
    configure("");
    ASSERT_EQ(build(), "rrrrr");
    const fs::path originals = scratch_ / "originals";
    write_whole_text(originals / "IMG_0001.png", "the user's own");
    for (int run = 0; run < 2; ++run) {
        const Outcome all = lumi("render " + quoted(package()) +
                                 " --all-views --mode lightfield --out " + quoted(originals));
        EXPECT_EQ(all.exit_code, 0) << all.talk;
        EXPECT_EQ(std::distance(fs::directory_iterator(originals), fs::directory_iterator()), 10);
    }
    EXPECT_EQ(read_whole_text(originals / "IMG_0001.png"), "the user's own");
    EXPECT_EQ(read_color_image(originals / "IMG_0009.lightfield.png").width(), 160);
    const auto fly_to = [&](const fs::path& out) {
        return lumi("render " + quoted(package()) + " --path views --frames 2 --size 48x32 --out " +
                    quoted(out));
    };
    const fs::path photos = scratch_ / "photos";
    write_whole_text(photos / "IMG_1.jpg", "the user's own");
    const Outcome refused = fly_to(photos);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.talk, HasSubstr("E-OUT-EXISTS"));
    EXPECT_EQ(read_whole_text(photos / "IMG_1.jpg"), "the user's own");

    const fs::path frames = scratch_ / "frames";
    EXPECT_EQ(fly_to(frames).exit_code, 0);
    EXPECT_EQ(fly_to(frames).exit_code, 0);
    const fs::path video = scratch_ / "100%d done" / "tour.MP4";
    EXPECT_EQ(fly_to(video).exit_code, 0);
    EXPECT_TRUE(fs::is_regular_file(video));
}

/// A program that says its version and does nothing else.
void write_useless_program(const fs::path& file) {
    write_whole_text(file, "#!/bin/sh\n[ \"$1\" = -version ] || { echo no encoder; exit 1; }\n");
    fs::permissions(file, fs::perms::owner_all);
}

TEST_F(RenderCommand, WithoutTheProgramsOfVideosNothingIsReadOrDrawn) {
    const fs::path programs = scratch_ / "programs";
    fs::create_directory(programs);
    const auto fly = [&](const fs::path& out) {
        return lumi(
            "render " + quoted(scratch_ / "missing.lumi") + " --path views --out " + quoted(out),
            "PATH=" + quoted(programs));
    };
    const Outcome without = fly(scratch_ / "tour.mp4");
    EXPECT_EQ(without.exit_code, 7);
    EXPECT_THAT(without.talk, HasSubstr("E-CHILD-MISSING"));
    EXPECT_THAT(without.talk, HasSubstr("ffmpeg"));
    write_useless_program(programs / "ffmpeg");
    EXPECT_THAT(fly(scratch_ / "tour.mp4").talk, HasSubstr("ffprobe"));
    // Folders of frames need neither.
    EXPECT_THAT(fly(scratch_ / "tour").talk, HasSubstr("missing.lumi"));
}

TEST_F(RenderCommand, KeepsTheFramesOfAVideoThatCannotBeMade) {
    configure("");
    ASSERT_EQ(build(), "rrrrr");
    const fs::path programs = scratch_ / "programs";
    write_useless_program(programs / "ffmpeg");
    write_useless_program(programs / "ffprobe");
    const fs::path video = scratch_ / "tour.mp4";
    const fs::path kept = scratch_ / "tour.mp4.frames";
    const auto fly = [&] {
        return lumi("render " + quoted(package()) + " --path views --frames 3 --size 48x32 --out " +
                        quoted(video),
                    "PATH=" + quoted(programs));
    };
    const Outcome outcome = fly();
    EXPECT_EQ(outcome.exit_code, 7);
    EXPECT_THAT(outcome.talk, HasSubstr("E-VIDEO-WRITE"));
    EXPECT_THAT(outcome.talk, HasSubstr(kept.string()));
    EXPECT_FALSE(fs::exists(video));
    EXPECT_EQ(read_color_image(kept / "frame-000003.png").width(), 48);
    EXPECT_FALSE(fs::exists(kept / "frame-000004.png"));
    EXPECT_FALSE(fs::exists(kept / "video.mp4"));

    write_whole_text(kept / "IMG_1.jpg", "the user's own");
    EXPECT_THAT(fly().talk, HasSubstr("E-OUT-EXISTS"));
}

TEST_F(RenderCommand, AWindowsScreenshotIsAPngToo) {
    // Its pose goes to a file of the same name that ends in .json.
    const Outcome outcome = lumi("view " + quoted(scratch_ / "missing.lumi") + " --screenshot " +
                                 quoted(scratch_ / "shot.json"));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.talk, HasSubstr("E-RENDER-OUT"));
    EXPECT_THAT(outcome.talk, HasSubstr("let --screenshot end in .png"));
}

}  // namespace
}  // namespace lumi
