#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "calib/pictures/image_io.h"
#include "calib/pictures/lost_color.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"
#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST(DoctorCommand, DoctorNamesWhatMakesACaptureHopeless) {
    const ScratchFolder scratch;
    for (const int shade : {60, 110, 160}) {
        const auto level = static_cast<std::uint8_t>(shade);
        write_png(scratch / "photos" / (std::to_string(shade) + ".png"),
                  ColorImage(320, 240, {level, level, level}));
    }
    const Outcome outcome = lumi("doctor --json " + quoted(scratch / "photos") + " --workspace " +
                                 quoted(scratch / "work"));
    EXPECT_EQ(outcome.exit_code, 4) << outcome.talk;
    const Json seen = Json::parse(outcome.out);
    EXPECT_EQ(seen.at("verdict"), "hopeless");
    EXPECT_GT(seen.at("expected_build").at("depth_mib"), 10);
    EXPECT_EQ(seen.at("findings").at(0).at("code"), "E-POSES-TEXTURE");
    EXPECT_FALSE(seen.at("findings").at(0).at("advice").get<std::string>().empty());
    EXPECT_THAT(read_whole_text(scratch / "work" / "doctor" / "match_graph.svg"),
                HasSubstr("160.png"));
    const Outcome told =
        lumi("doctor " + quoted(scratch / "photos") + " --workspace " + quoted(scratch / "work"));
    EXPECT_THAT(told.out, testing::Not(HasSubstr("rays meet"))) << "there is no pair";
}

TEST(DoctorCommand, AnOddNameIsLeftOutAndNeitherABugNorATerminalsCommand) {
    const ScratchFolder scratch;
    for (int i = 0; i < 3; ++i) {
        write_png(scratch / "photos" / (std::to_string(i) + ".png"),
                  wavy_picture(320, 240, 100.0 * i));
    }
    write_whole_text(scratch / "photos" / "caf\xe9.jpg", "");
    write_whole_text(scratch / "photos" / "clear\x1b[2J.jpg", "\xff\xd8\xff\xe0 and no more");
    const std::string photos = quoted(scratch / "photos");
    const Outcome examined =
        lumi("doctor --json " + photos + " --workspace " + quoted(scratch / "doctor"));
    EXPECT_THAT(examined.exit_code, testing::AnyOf(0, 4, 5)) << examined.talk;
    const Json seen = Json::parse(examined.out);
    EXPECT_EQ(seen.at("left_out").at(0).at("name"), "caf\\xe9.jpg");
    EXPECT_EQ(seen, Json::parse(read_whole_text(scratch / "doctor" / "doctor" / "doctor.json")));

    const Outcome ingested = lumi("ingest " + photos + " --workspace " + quoted(scratch / "work"));
    EXPECT_EQ(ingested.exit_code, 0) << ingested.talk;
    EXPECT_THAT(ingested.talk, HasSubstr("left out caf\\xe9.jpg (E-INGEST-UNREADABLE)"));
    EXPECT_THAT(ingested.talk, HasSubstr("left out clear\\x1b[2J.jpg"));
    EXPECT_THAT(ingested.talk, testing::Not(HasSubstr("\x1b")));
}

TEST(DoctorCommand, AHeldOutPhotographThatIsNotThereIsSaidByDoctorAndIngest) {
    const ScratchFolder scratch;
    for (int i = 0; i < 3; ++i)
        write_png(scratch / "photos" / ("view" + std::to_string(i) + ".png"),
                  wavy_picture(320, 240, 100.0 * i));
    write_whole_text(scratch / "my.toml",
                     "[capture]\nphotos = \"photos\"\n[evaluate]\nhold_out = [\"view1.jpg\"]\n");
    for (const char* command : {"doctor ", "ingest "}) {
        const Outcome outcome = lumi(command + quoted(scratch / "my.toml") + " --workspace " +
                                     quoted(scratch / "work"));
        EXPECT_EQ(outcome.exit_code, 2) << outcome.talk;
        EXPECT_THAT(outcome.talk, HasSubstr("error E-EVAL-NAME"));
        EXPECT_THAT(outcome.talk, HasSubstr("my.toml:4: hold_out: "));
        EXPECT_THAT(outcome.talk, HasSubstr("did you mean `view1.png`?"));
    }
}

TEST(DoctorCommand, FramesASecondOfPhotographsAreSaidToTellNothing) {
    const ScratchFolder scratch;
    for (int i = 0; i < 2; ++i)
        write_png(scratch / "photos" / (std::to_string(i) + ".png"),
                  wavy_picture(320, 240, 100.0 * i));
    for (const char* fps : {"5.0", "2.0"}) {
        write_whole_text(scratch / "my.toml", std::string("[capture]\nphotos = \"photos\"\n") +
                                                  "video_fps = " + fps + "\n");
        const Outcome outcome = lumi("ingest " + quoted(scratch / "my.toml") + " --workspace " +
                                     quoted(scratch / "work"));
        const auto says_it = HasSubstr("[capture] video_fps tells nothing of photographs");
        if (std::string(fps) == "5.0") {
            EXPECT_THAT(outcome.talk, says_it);
        } else {
            EXPECT_THAT(outcome.talk, testing::Not(says_it)) << "what stands in each config.toml";
        }
    }
}

TEST(DoctorCommand, APhotographWithoutColorsAmongColoredOnesIsNamedByDoctorAndReport) {
    const ScratchFolder scratch;
    for (int i = 0; i < 3; ++i) {
        const ColorImage picture = wavy_picture(320, 240, 100.0 * i);
        write_png(scratch / "photos" / ("view" + std::to_string(i) + ".png"),
                  i == 1 ? without_color(picture) : picture);
    }
    const auto says_it = HasSubstr(
        "1 photograph is black and white, the others have colours: "
        "view1.png");
    const std::string photos = quoted(scratch / "photos") + " --workspace ";
    EXPECT_THAT(lumi("doctor " + photos + quoted(scratch / "doctor")).out, says_it);
    EXPECT_THAT(lumi("ingest " + photos + quoted(scratch / "work")).talk, says_it);
    EXPECT_THAT(read_whole_text(scratch / "work" / "report.html"), says_it);
}

/// Photographs of a scene that passes by unevenly, with a bar below and a label laid over each.
void write_with_overlays(const fs::path& folder) {
    std::mt19937 random(8);
    for (int i = 0; i < 12; ++i) {
        ColorImage picture = wavy_picture(320, 240, static_cast<double>(random() % 800));
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (y >= 210) picture(x, y) = {0, 0, 0};
                if (x >= 200 && x < 270 && y >= 120 && y < 150) picture(x, y) = {255, 255, 255};
            }
        }
        write_png(folder / (std::to_string(100 + i) + ".png"), picture);
    }
}

TEST(DoctorCommand, WhatWasLaidOverPhotographsIsSaidByDoctorAndReport) {
    const ScratchFolder scratch;
    write_with_overlays(scratch / "photos");
    const auto says_it = testing::AllOf(HasSubstr("bars were cut off: 32 pixels below"),
                                        HasSubstr("watermark or black corner was painted over"));
    const Outcome examined =
        lumi("doctor " + quoted(scratch / "photos") + " --workspace " + quoted(scratch / "doctor"));
    EXPECT_THAT(examined.exit_code, testing::AnyOf(4, 5)) << "shifted pictures have no depth";
    EXPECT_THAT(examined.out, says_it);
    const std::string workspace = " --workspace " + quoted(scratch / "work");
    const Outcome ingested = lumi("ingest " + quoted(scratch / "photos") + workspace);
    EXPECT_EQ(ingested.exit_code, 0) << ingested.talk;
    EXPECT_THAT(read_whole_text(scratch / "work" / "report.html"), says_it);
}

/// 1600x120: as wide as a build makes copies, and twice as wide as the doctor does.
TEST(DoctorCommand, WhatIsTinyIsAskedAtTheWidthOfTheBuild) {
    const ScratchFolder scratch;
    for (int i = 0; i < 3; ++i) {
        write_png(scratch / "photos" / (std::to_string(i) + ".png"),
                  wavy_picture(1600, 120, 100.0 * i));
    }
    write_png(scratch / "photos" / "strip.png", wavy_picture(400, 60, 50));
    write_png(scratch / "photos" / "strip again.png", wavy_picture(400, 60, 50));
    const std::string command =
        "doctor --json " + quoted(scratch / "photos") + " --workspace " + quoted(scratch / "work");
    const Json seen = Json::parse(lumi(command).out);
    ASSERT_EQ(seen.at("left_out").size(), 2U) << seen;
    for (const std::size_t i : {0U, 1U}) {
        EXPECT_EQ(seen.at("left_out").at(i).at("name"), i == 0 ? "strip again.png" : "strip.png");
        EXPECT_EQ(seen.at("left_out").at(i).at("code"), "E-INGEST-TINY");
    }
}

TEST(DoctorCommand, LeavesNothingBehindAndTakesNothingAway) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "photos" / "damaged.png", "");
    write_whole_text(scratch / "work" / "doctor" / "scratch" / "mine.txt", "the user's own");
    const Outcome outcome =
        lumi("doctor " + quoted(scratch / "photos") + " --workspace " + quoted(scratch / "work"));
    EXPECT_EQ(outcome.exit_code, 3) << outcome.talk;
    EXPECT_EQ(read_whole_text(scratch / "work/doctor/scratch/mine.txt"), "the user's own");
    EXPECT_EQ(std::distance(fs::directory_iterator(scratch / "work/doctor"), {}), 1);
}

}  // namespace
}  // namespace lumi
