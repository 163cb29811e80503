#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "calib/ingest/made_by_lumi.h"
#include "calib/pictures/image_io.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"
#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::StartsWith;

TEST(CommandLine, HelpBeginsWithAnExample) {
    EXPECT_THAT(lumi("--help").out, StartsWith("Example: lumi "));
    for (const std::string command : {"build",         "calibrate",
                                      "doctor",        "ingest",
                                      "poses",         "mesh",
                                      "depth",         "pack",
                                      "render",        "view",
                                      "evaluate",      "chart",
                                      "stress",        "select",
                                      "plan",          "compare-pictures",
                                      "compare-poses", "compare-evaluations",
                                      "inspect",       "validate",
                                      "synth",         "bench",
                                      "bench-poses",   "bench-boards",
                                      "bench-depth",   "bench-flicker",
                                      "bench-mesh",    "bench-rivals",
                                      "bench-hazards", "bench-orbit",
                                      "fuse",          "regression",
                                      "gallery"}) {
        const Outcome help = lumi(command + " --help");
        EXPECT_EQ(help.exit_code, 0) << command;
        EXPECT_THAT(help.out, StartsWith("Example: lumi " + command));
    }
}

TEST(CommandLine, AWrongCommandLineIsUsage) {
    EXPECT_EQ(lumi("").exit_code, 2);
    EXPECT_EQ(lumi("biuld").exit_code, 2);
    EXPECT_EQ(lumi("build").exit_code, 2);
    EXPECT_EQ(lumi("build --no-such-flag x.toml").exit_code, 2);
    EXPECT_EQ(lumi("build --threads -3 x.toml").exit_code, 2);
    EXPECT_EQ(lumi("render p.lumi --out x.png").exit_code, 2);
    EXPECT_EQ(lumi("").out, "");
    EXPECT_EQ(lumi("bench-orbit --minutes 1 --warm-up 1 no.lumi").exit_code, 2);
}

TEST(CommandLine, WhatIsNoNumberIsUsage) {
    for (const char* line :
         {"plan w --wish nan", "plan w --wish inf", "plan w --wish 0", "bench p.lumi --fps nan",
          "render p.lumi --view a --out a.png --focal-depth nan",
          "render p.lumi --view a --out a.png --aperture nan",
          "render p.lumi --path views --out a.mp4 --video-fps nan", "view p.lumi --fps nan",
          "bench-orbit p.lumi --minutes nan", "bench-mesh --roughness nan",
          "bench-mesh --scene 1.5", "calibrate p --square-ratio nan"}) {
        const Outcome outcome = lumi(line);
        EXPECT_EQ(outcome.exit_code, 2) << line;
        EXPECT_THAT(outcome.talk, HasSubstr(": expected ")) << line;
    }
    EXPECT_THAT(lumi("plan w --wish inf").talk,
                HasSubstr("--wish: expected a number above 0, found inf\n"));
    EXPECT_THAT(lumi("bench-mesh --roughness nan").talk,
                HasSubstr("--roughness: expected 0 to 0.9, found nan\n"));
}

TEST(CommandLine, AFocalViewNeedsADepth) {
    const Outcome no_depth =
        lumi("render p.lumi --view a --out a.png --mode lightfield --focal-view a");
    EXPECT_EQ(no_depth.exit_code, 2);
    EXPECT_THAT(no_depth.talk, HasSubstr("--focal-depth"));
}

TEST(CommandLine, VersionNamesWhatLumiIsBuiltFrom) {
    const Outcome version = lumi("--version");
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_THAT(version.out, StartsWith("lumi "));
    for (const char* name : {"COLMAP", "OpenCV ", "Ceres ", "CGAL ", "OpenImageIO "}) {
        EXPECT_THAT(version.out, HasSubstr(name));
    }
    const Outcome for_machines = lumi("--json --version");
    EXPECT_EQ(for_machines.exit_code, 0);
    EXPECT_THAT(version.out,
                StartsWith(Json::parse(for_machines.out).at("version").get<std::string>()));
}

TEST(CommandLine, ErrorsSayWhatWhereAndWhatToDo) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "c.toml", "[capture]\nphotos = \"p\"\nmax_with_px = 3\n");
    const Outcome outcome = lumi("build " + quoted(scratch / "c.toml"));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.talk, HasSubstr("error E-CONFIG-KEY: " + (scratch / "c.toml").string() +
                                        ":3: unknown key `capture.max_with_px`\n  -> "));
}

TEST(CommandLine, CalibrationRefusesWhatItCannotDoByName) {
    const ScratchFolder scratch;
    write_png(scratch / "a.png", GrayImage(320, 240, 90));
    const std::string folder = quoted(scratch.path());
    EXPECT_EQ(lumi("calibrate " + folder + " --board hexagons").exit_code, 2);
    EXPECT_EQ(lumi("calibrate " + folder + " --size 9by6").exit_code, 2);
    EXPECT_EQ(lumi("calibrate " + folder + " --models THIN_PRISM").exit_code, 2);
    const Outcome outcome = lumi("--json calibrate " + folder);
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_EQ(Json::parse(outcome.out)["error"]["code"], "E-BOARDS-NOTFOUND");
}

TEST(CommandLine, ErrorsAreJsonForMachines) {
    const Outcome outcome = lumi("inspect --json /no/such.lumi");
    EXPECT_EQ(outcome.exit_code, 3);
    const Json error = Json::parse(outcome.out).at("error");
    EXPECT_EQ(error.at("exit_code"), 3);
    EXPECT_THAT(error.at("code").get<std::string>(), StartsWith("E-"));
}

TEST(CommandLine, MachinesGetOneObjectWhateverHappens) {
    const Json invalid = Json::parse(lumi("--json validate /no/such.lumi").out);
    EXPECT_EQ(invalid.at("valid"), false);
    EXPECT_EQ(invalid.at("error").at("code"), "E-PACKAGE-MISSING");
    for (const char* wrong : {"--json", "--json biuld", "build --json", "build --json --no x.toml",
                              "--json build --threads -3 x.toml"}) {
        const Outcome outcome = lumi(wrong);
        EXPECT_EQ(outcome.exit_code, 2) << wrong;
        EXPECT_EQ(Json::parse(outcome.out).at("error").at("code"), "E-USAGE") << wrong;
        EXPECT_THAT(outcome.talk, StartsWith("error E-USAGE: ")) << wrong;
    }
}

TEST(CommandLine, AMissingInputIsBadInput) {
    const ScratchFolder scratch;
    EXPECT_EQ(lumi("build " + quoted(scratch / "no.toml")).exit_code, 3);
    EXPECT_EQ(lumi("evaluate " + quoted(scratch.path())).exit_code, 3);
    EXPECT_EQ(lumi("validate " + quoted(scratch / "no.lumi")).exit_code, 3);
    EXPECT_EQ(lumi("bench-boards " + quoted(scratch / "no-boards")).exit_code, 3);
    const Outcome poses =
        lumi("compare-poses " + quoted(scratch / "a") + " " + quoted(scratch / "b"));
    EXPECT_EQ(poses.exit_code, 3);
    EXPECT_THAT(poses.talk, HasSubstr((scratch / "a").string() + ": "));
}

TEST(CommandLine, WhatCannotBeWrittenIsRefusedBeforeTheWork) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "file", "no folder");
    const std::string out = quoted(scratch / "file/out");
    write_whole_text(scratch / "sweep.toml",
                     "[capture]\nphotos = \"no\"\n[sweep]\ndepth.model = [\"plane\"]\n");
    write_whole_text(scratch / "inside.toml",
                     "workspace = \"file/out\"\n[capture]\nphotos = \"no\"\n");
    // Nothing that they read exists: where results go is looked at first.
    for (const std::string& line :
         {"fuse no.lumi --out " + quoted(scratch / "file/out.ply"), "stress no.lumi --out " + out,
          "bench-flicker no.lumi --out " + out, "bench-depth no-workspace --out " + out,
          "bench-hazards --out " + out, "bench-poses no.toml --chart " + out,
          "regression no-workspace --write " + out, "select no-workspace --chart " + out,
          "gallery no-workspace --out " + out, "calibrate no-boards --out " + out,
          "synth no.toml --out " + out, "chart " + quoted(scratch / "sweep.toml") + " --out " + out,
          "evaluate --leave-one-out " + quoted(scratch / "inside.toml"),
          "render no.lumi --view a --out " + quoted(scratch / "file/out.png"),
          "render no.lumi --all-views --out " + out, "render no.lumi --path views --out " + out,
          "view no.lumi --screenshot " + quoted(scratch / "file/out.png"),
          "compare-pictures no.png no.png --flip-map " + quoted(scratch / "file/out.png")}) {
        const Outcome outcome = lumi(line);
        EXPECT_EQ(outcome.exit_code, 3) << line;
        EXPECT_THAT(outcome.talk, HasSubstr("error E-FILE-WRITE")) << line;
    }
    EXPECT_EQ(read_whole_text(scratch / "file"), "no folder");
}

TEST(CommandLine, AnEmptyTextIsUsage) {
    for (const char* line :
         {"build ''", "doctor ''", "evaluate ''", "render p.lumi --eye '' --out a.png",
          "render p.lumi --path '' --out a", "render p.lumi --view a --out ''", "synth --out ''",
          "build photos --workspace ''"}) {
        const Outcome outcome = lumi(line);
        EXPECT_EQ(outcome.exit_code, 2) << line;
        EXPECT_THAT(outcome.talk, HasSubstr(": expected a value, found an empty one")) << line;
    }
}

TEST(CommandLine, WhatContradictsItselfIsUsage) {
    for (const char* line :
         {"render p.lumi --view a --out a.png --fade --no-fade", "view p.lumi --no-fade --fade",
          "view p.lumi --eye a.json --path b.json", "view p.lumi --view a --eye a.json",
          "view p.lumi --planned 1 --path a.json", "view p.lumi --path a.json --screenshot a.png",
          "render p.lumi --view a --out a.png --supersample --jagged",
          "render p.lumi --view a --out a.png --frames 5",
          "render p.lumi --all-views --out a --video-fps 5", "build -v -q p.toml",
          "fuse p.lumi --out a.ply --agreeing 0", "fuse p.lumi --out a.ply --max-points 10",
          "bench-depth w --out o --max-width -5", "bench-hazards --out h --hazard boredom",
          "bench-mesh --seed -1", "bench-hazards --out h --seed -1"}) {
        const Outcome outcome = lumi(line);
        EXPECT_EQ(outcome.exit_code, 2) << line;
        EXPECT_THAT(outcome.talk, HasSubstr("error E-USAGE")) << line;
    }
}

TEST(CommandLine, WhatAModeDoesNotHeedIsUsage) {
    for (const char* options :
         {"--mode paper2001 --fade", "--mode heigl --fade", "--mode adaptive --jagged",
          "--mode lightfield --jagged", "--mode paper2001 --jagged"}) {
        const Outcome outcome = lumi("render p.lumi --view a --out a.png " + std::string(options));
        EXPECT_EQ(outcome.exit_code, 2) << options;
        EXPECT_THAT(outcome.talk, HasSubstr("error E-RENDER-OPTION")) << options;
    }
    EXPECT_THAT(lumi("view p.lumi --debug mood").talk, HasSubstr("error E-RENDER-DEBUG"));
}

TEST(CommandLine, AWorkspaceIsNoFolderOfPhotographs) {
    const ScratchFolder scratch;
    for (const char* file : {"config.toml", "stages.json"}) write_whole_text(scratch / file, "");
    for (const char* command : {"build ", "doctor ", "chart ", "evaluate --leave-one-out "}) {
        const Outcome outcome = lumi(command + quoted(scratch.path()));
        EXPECT_EQ(outcome.exit_code, 3) << command;
        EXPECT_THAT(outcome.talk, HasSubstr("E-CONFIG-WORKSPACE")) << command;
        EXPECT_THAT(outcome.talk, HasSubstr((scratch / "config.toml").string())) << command;
    }
    write_whole_text(scratch / "config.toml", "[capture]\nphotos = \".\"\n");
    EXPECT_THAT(
        lumi("doctor --workspace " + quoted(scratch / "w") + " " + quoted(scratch.path())).talk,
        HasSubstr("E-INGEST"))
        << "photographs beside what was made of them";
}

TEST(CommandLine, WhatIsNoConfigurationIsNotReadAsOne) {
    const ScratchFolder scratch;
    write_png(scratch / "one.png", GrayImage(320, 240, 90));
    write_whole_text(scratch / "empty.mp4", "");
    write_whole_text(scratch / "notes.mp4", "hello world\n");
    write_whole_text(scratch / "mesh.ply", "ply\nformat ascii 1.0\nend_header\n");
    const std::string workspace = " --workspace " + quoted(scratch / "w");
    const auto talk_of = [&](const std::string& file) {
        return lumi("build " + quoted(scratch / file) + workspace).talk;
    };
    EXPECT_THAT(talk_of("one.png"), HasSubstr("E-CONFIG-PHOTOGRAPH"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "w"));
    EXPECT_THAT(talk_of("mesh.ply"), HasSubstr("a configuration in TOML, a folder of photographs"));
    for (const char* file : {"empty.mp4", "notes.mp4"})
        EXPECT_THAT(talk_of(file), HasSubstr("E-INGEST-NOVIDEO")) << file;
}

TEST(CommandLine, AHazardIsNamedWhereThereIsNoneAndMayBeNamedTwice) {
    const ScratchFolder scratch;
    const std::string command = "bench-hazards --out " + quoted(scratch / "h") + " --step 99 ";
    EXPECT_THAT(lumi(command + "--hazard boredom").talk, HasSubstr("boredom"));
    EXPECT_THAT(lumi(command + "--hazard noise --hazard noise").talk, HasSubstr("E-HAZARD-STEP"));
}

TEST(CommandLine, BoardsThatAllFailEndWithTheErrorOfTheFirst) {
    const ScratchFolder scratch;
    write_png(scratch / "a.png", GrayImage(320, 240, 90));
    const Outcome outcome = lumi("--json bench-boards " + quoted(scratch.path()));
    EXPECT_EQ(outcome.exit_code, 4);
    const Json result = Json::parse(outcome.out);
    EXPECT_EQ(result.at("error").at("code"), "E-BOARDS-NOTFOUND");
    EXPECT_EQ(result.at("sets").at(0).at("refused"), "E-BOARDS-NOTFOUND");
    EXPECT_FALSE(result.at("sets").at(0).at("reason").get<std::string>().empty());
}

TEST(CommandLine, PosesOfAWorkspaceAreSaidToLieInAFolderOfIt) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "w/config.toml", "name = \"w\"\n");
    std::filesystem::create_directories(scratch / "w/poses/sparse");
    const Outcome outcome =
        lumi("compare-poses " + quoted(scratch / "w") + " " + quoted(scratch / "w"));
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.talk,
                HasSubstr("did you mean " + (scratch / "w/poses/sparse").string() + "?"));
}

TEST(CommandLine, FramesOfAllViewsDoNotReplaceAFile) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "a.png", "mine");
    const Outcome outcome = lumi("render no.lumi --all-views --out " + quoted(scratch / "a.png"));
    EXPECT_THAT(outcome.talk, HasSubstr("E-OUT-EXISTS"));
    EXPECT_EQ(read_whole_text(scratch / "a.png"), "mine");
}

TEST(CommandLine, APathWithNothingThereIsCalledSo) {
    for (const char* line : {"doctor nope", "build nope.toml", "poses nope", "chart nope.toml"}) {
        const Outcome outcome = lumi(line);
        EXPECT_EQ(outcome.exit_code, 3) << line;
        EXPECT_THAT(outcome.talk, HasSubstr("there is nothing at this path")) << line;
    }
}

TEST(CommandLine, AFolderWithAConfigurationOfTheUsersIsNoWorkspace) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "config.toml", "name = \"cat\"\n");
    for (const char* command : {"plan ", "select ", "evaluate ", "regression "}) {
        const Outcome outcome = lumi(command + quoted(scratch.path()));
        EXPECT_EQ(outcome.exit_code, 3) << command;
        EXPECT_THAT(outcome.talk, HasSubstr("E-WORKSPACE-NONE")) << command;
        EXPECT_THAT(outcome.talk, testing::Not(HasSubstr("--workspace"))) << command;
    }
}

TEST(CommandLine, AChartTakesNoFolderOfTheUsersForLumis) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/a.png", GrayImage(320, 240, 90));
    write_png(scratch / "mine/a.png", GrayImage(320, 240, 90));
    const std::string chart =
        "chart " + quoted(scratch / "c.toml") + " --growth-alone --out " + quoted(scratch / "mine");
    write_whole_text(scratch / "c.toml", "[capture]\nphotos = \"photos\"\n");
    EXPECT_THAT(lumi(chart).talk, HasSubstr("E-GROWTH-NOTHING"));
    EXPECT_FALSE(is_made_by_lumi(scratch / "mine"));
    write_whole_text(scratch / "c.toml",
                     "[capture]\nphotos = \"photos\"\n[growth]\nphotographs = [1]\n");
    EXPECT_THAT(lumi(chart).talk, HasSubstr("E-OUT-EXISTS"));
    EXPECT_FALSE(is_made_by_lumi(scratch / "mine"));
}

TEST(CommandLine, GrowthIsMeasuredByOneRunAtATime) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/a.png", GrayImage(320, 240, 90));
    write_whole_text(scratch / "c.toml",
                     "[capture]\nphotos = \"photos\"\n[growth]\nphotographs = [1]\n");
    std::filesystem::create_directory(scratch / "chart");
    const Outcome outcome = lumi("chart " + quoted(scratch / "c.toml") + " --growth-alone --out " +
                                     quoted(scratch / "chart"),
                                 "flock " + quoted(scratch / "chart/.lock"));
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.talk, HasSubstr("E-WORKSPACE-BUSY"));
}

TEST(CommandLine, ATargetFindsOutBeforeItMeasuresThatItMayNotWrite) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/a.png", GrayImage(320, 240, 90));
    write_whole_text(scratch / "c.toml",
                     "[capture]\nphotos = \"photos\"\n[evaluate]\nhold_out_every = 2\n");
    write_whole_text(scratch / "w/depth/notes.txt", "the user's own");
    const Outcome outcome = lumi("build " + quoted(scratch / "c.toml") +
                                 " --target 20dB --workspace " + quoted(scratch / "w"));
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.talk, HasSubstr("E-WORKSPACE-FOREIGN"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "w-chart"));
}

TEST(CommandLine, APackageIsNoWorkspace) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "lumigraph.json", "{}");
    write_whole_text(scratch / "config.toml", "name = \"cat\"\n");
    for (const char* command : {"plan ", "select ", "evaluate ", "regression "}) {
        const Outcome outcome = lumi(command + quoted(scratch.path()));
        EXPECT_EQ(outcome.exit_code, 3) << command;
        EXPECT_THAT(outcome.talk, HasSubstr("E-WORKSPACE-NONE")) << command;
        EXPECT_THAT(outcome.talk, HasSubstr(": is a package, ")) << command;
    }
}

TEST(CommandLine, APackageIsNoFolderOfPhotographs) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "cat.lumi/lumigraph.json", "{}");
    for (const char* command : {"build ", "doctor ", "ingest "}) {
        const Outcome outcome = lumi(command + quoted(scratch / "cat.lumi"));
        EXPECT_EQ(outcome.exit_code, 3) << command;
        EXPECT_THAT(outcome.talk, HasSubstr("E-CONFIG-PACKAGE")) << command;
    }
}

TEST(CommandLine, PicturesAreComparedByAllFigures) {
    const ScratchFolder scratch;
    write_png(scratch / "a.png", ColorImage(64, 48, {100, 100, 100}));
    write_png(scratch / "b.png", ColorImage(64, 48, {110, 110, 110}));
    write_png(scratch / "small.png", ColorImage(48, 48, {100, 100, 100}));
    const std::string a = " " + quoted(scratch / "a.png");
    const Outcome compared = lumi("--json compare-pictures" + a + " " + quoted(scratch / "b.png") +
                                  " --flip-map " + quoted(scratch / "map.png"));
    ASSERT_EQ(compared.exit_code, 0) << compared.talk;
    const Json figures = Json::parse(compared.out);
    EXPECT_NEAR(figures.at("psnr_db").get<double>(), 20 * std::log10(255.0 / 10.0), 1e-9);
    EXPECT_GT(figures.at("flip").get<double>(), 0.0);
    EXPECT_TRUE(figures.at("edge_sharpness").is_null());
    EXPECT_EQ(read_color_image(scratch / "map.png").width(), 64);
    const std::string table = lumi("compare-pictures" + a + a).out;
    EXPECT_THAT(table, HasSubstr("width_px              64\n"));
    EXPECT_THAT(table, HasSubstr("flip                  0.0"));
    const Outcome other_ending =
        lumi("compare-pictures" + a + a + " --flip-map " + quoted(scratch / "map.jpg"));
    EXPECT_EQ(other_ending.exit_code, 2);
    EXPECT_THAT(other_ending.talk, HasSubstr("let --flip-map end in .png"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "map.jpg"));
    const Outcome refused = lumi("compare-pictures" + a + " " + quoted(scratch / "small.png"));
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_THAT(refused.talk, HasSubstr("E-EVAL-SIZE"));
}

TEST(CommandLine, AnInterruptionEndsWith130) {
    const ScratchFolder scratch;
    // On one thread the demo scene takes a minute; it is stopped after three seconds, when a busy
    // machine has begun with it, too. In the foreground `timeout` signals once: a second
    // interruption ends without a word.
    const Outcome outcome = lumi("synth --threads 1 --out " + quoted(scratch / "scene"),
                                 "timeout --foreground --preserve-status --signal=INT 3");
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_THAT(outcome.talk, HasSubstr("error E-INTERRUPTED"));
}

}  // namespace
}  // namespace lumi
