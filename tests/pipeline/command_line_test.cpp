#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "calib/pictures/image_io.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"
#include "tests/pipeline/built_program.h"
#include "tests/pipeline/told_choices.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
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

TEST(CommandLine, VersionNamesWhatLumiIsBuiltFrom) {
    const Outcome version = lumi("--version");
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_THAT(version.out, StartsWith("lumi "));
    for (const char* name : {"COLMAP", "OpenCV ", "Ceres ", "CGAL ", "OpenImageIO "}) {
        EXPECT_THAT(version.out, HasSubstr(name));
    }
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
    EXPECT_EQ(
        lumi("compare-poses " + quoted(scratch / "a") + " " + quoted(scratch / "b")).exit_code, 3);
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
    EXPECT_THAT(lumi("compare-pictures" + a + a).out, HasSubstr("flip                  0.0"));
    const Outcome refused = lumi("compare-pictures" + a + " " + quoted(scratch / "small.png"));
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_THAT(refused.talk, HasSubstr("E-EVAL-SIZE"));
}

TEST(CommandLine, DoctorNamesWhatMakesACaptureHopeless) {
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
}

TEST(CommandLine, AnOddNameIsLeftOutAndNeitherABugNorATerminalsCommand) {
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

TEST(CommandLine, WhatWasLaidOverPhotographsIsSaidByDoctorAndReport) {
    const ScratchFolder scratch;
    write_with_overlays(scratch / "photos");
    const auto says_it = testing::AllOf(HasSubstr("bars were cut off: 32 pixels below"),
                                        HasSubstr("logo or watermark was painted over"));
    const Outcome examined =
        lumi("doctor " + quoted(scratch / "photos") + " --workspace " + quoted(scratch / "doctor"));
    EXPECT_THAT(examined.exit_code, testing::AnyOf(4, 5)) << "shifted pictures have no depth";
    EXPECT_THAT(examined.out, says_it);
    const std::string workspace = " --workspace " + quoted(scratch / "work");
    const Outcome ingested = lumi("ingest " + quoted(scratch / "photos") + workspace);
    EXPECT_EQ(ingested.exit_code, 0) << ingested.talk;
    EXPECT_THAT(read_whole_text(scratch / "work" / "report.html"), says_it);
}

TEST(CommandLine, DepthIsAskedForItsStabilityOrOnWorkspaces) {
    const ScratchFolder scratch;
    const std::string out = " --out " + quoted(scratch / "stability");
    EXPECT_EQ(lumi("bench-depth" + out).exit_code, 2);
    EXPECT_EQ(lumi("bench-depth --stability work/some" + out).exit_code, 2);
    EXPECT_EQ(lumi("bench-depth --stability --hazard boredom" + out).exit_code, 2);
    const Outcome outcome =
        lumi("bench-depth --json --stability --quick --hazard noise --model plane" + out);
    ASSERT_EQ(outcome.exit_code, 0);
    const Json json = Json::parse(outcome.out);
    ASSERT_EQ(json.at("rows").size(), 3U);
    EXPECT_EQ(json.at("rows").at(0).at("rungs").at(0).at("model"), "plane");
    EXPECT_EQ(json, Json::parse(read_whole_text(scratch / "stability" / "stability.json")));
    EXPECT_TRUE(std::filesystem::exists(scratch / "stability" / "stability.csv"));
    EXPECT_TRUE(std::filesystem::exists(scratch / "stability" / "stability-noise.svg"));
}

TEST(CommandLine, AnInterruptionEndsWith130) {
    const ScratchFolder scratch;
    // The demo scene takes tens of seconds; it is stopped after three, when a busy machine has
    // begun with it, too. In the foreground `timeout` signals once: a second interruption ends
    // without a word.
    const Outcome outcome = lumi("synth --out " + quoted(scratch / "scene"),
                                 "timeout --foreground --preserve-status --signal=INT 3");
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_THAT(outcome.talk, HasSubstr("error E-INTERRUPTED"));
}

/// The textured box with its true poses, and the line over it.
class Line : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        scene_ = std::make_unique<ScratchFolder>();
        SilentProgress progress;
        synthesize_into(scene_->path(), textured_box_description(), 0, progress);
    }
    static void TearDownTestSuite() { scene_.reset(); }

    /// With depth from scene points and drawing that is told, unless a test is about these.
    void configure(const std::string& more, const std::string& depth = kSparseDepth,
                   const std::string& drawing = kToldDrawing) const {
        write_whole_text(config_path(), "name = \"box\"\n[capture]\nphotos = \"" +
                                            (scene_->path() / "photos").string() +
                                            "\"\nimport = \"" +
                                            (scene_->path() / "truth" / "sparse").string() +
                                            "\"\n" + more + depth + drawing);
    }
    /// States of the stages, in their order: 'r' for run, 'u' for up to date.
    std::string build(const std::string& command = "build") const {
        const Outcome outcome = lumi(command + " --json " + quoted(config_path()) +
                                     " --workspace " + quoted(workspace()));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        std::string states;
        const Json result = Json::parse(outcome.out);
        for (const Json& stage : result.at("stages")) {
            states += stage.at("state") == "run" ? 'r' : 'u';
        }
        return states;
    }
    [[nodiscard]] fs::path config_path() const { return scratch_ / "box.toml"; }
    [[nodiscard]] fs::path workspace() const { return scratch_ / "work"; }
    [[nodiscard]] fs::path package() const { return workspace() / "box.lumi"; }

    static std::unique_ptr<ScratchFolder> scene_;
    ScratchFolder scratch_;
};

std::unique_ptr<ScratchFolder> Line::scene_;

TEST_F(Line, RunsWhatHasToBeRunAndNoMore) {
    configure("");
    EXPECT_EQ(build("mesh"), "rrr");
    EXPECT_EQ(build(), "uuurr");
    EXPECT_EQ(build(), "uuuuu");

    const std::string narrow = std::string(kSparseDepth) + "max_width_px = 100\n";
    configure("", narrow);
    EXPECT_EQ(build(), "uuurr");
    configure("[evaluate]\nhold_out = [\"IMG_0005.png\"]\n", narrow);
    EXPECT_EQ(build(), "uurrr");

    for (const auto& entry : fs::recursive_directory_iterator(scene_->path())) {
        fs::last_write_time(entry.path(), fs::file_time_type::clock::now());
    }
    EXPECT_EQ(build(), "uuuuu");
}

TEST_F(Line, MakesHarmedFilesAgain) {
    configure("");
    static_cast<void>(build());
    const fs::path harmed = workspace() / "depth" / "IMG_0002.inverse_depth.tif";
    const std::string before = read_whole_text(harmed);
    write_whole_text(harmed, "harmed");
    EXPECT_EQ(build(), "uuuru");  // The same depth as before: what was packed can stay.
    EXPECT_EQ(read_whole_text(harmed), before);
    fs::remove(package() / "lumigraph.json");
    EXPECT_EQ(build(), "uuuur");
}

TEST_F(Line, WhatIsAskedOfDrawingReachesThePackage) {
    for (const std::string answer : {"yes", "no"}) {
        const bool is_yes = answer == "yes";
        const int depth_views = is_yes ? 3 : 4;
        const double block_px = is_yes ? 1.5 : 1.25;
        const double error_px = is_yes ? 2.5 : 1.5;
        const double tolerance_px = is_yes ? 4.5 : 2.25;
        const double noisy_px = is_yes ? 0.5 : 0.75;
        configure("", kSparseDepth,
                  "[render]\ndepth_views = " + std::to_string(depth_views) +
                      "\ndepth_block_px = " + std::to_string(block_px) + "\nfill_holes = \"" +
                      answer + "\"\ncheck_guesses = \"" + answer + "\"\ndraw_thin = \"" + answer +
                      "\"\ntriangle_error_px = " + std::to_string(error_px) +
                      "\nocclusion_tolerance_px = " + std::to_string(tolerance_px) +
                      "\nnoisy_depth_error_px = " + std::to_string(noisy_px) + "\n");
        static_cast<void>(build());
        const Json inspected = Json::parse(lumi("inspect --json " + quoted(package())).out);
        EXPECT_EQ(inspected.at("depth_views"), depth_views);
        EXPECT_EQ(inspected.at("depth_block_px"), block_px);
        EXPECT_EQ(inspected.at("fills_holes"), is_yes);
        EXPECT_EQ(inspected.at("checks_guesses"), is_yes);
        EXPECT_EQ(inspected.at("draws_thin"), is_yes);
        EXPECT_EQ(inspected.at("triangle_error_px"), error_px);
        EXPECT_EQ(inspected.at("occlusion_tolerance_px"), tolerance_px);
        EXPECT_EQ(inspected.at("noisy_depth_error_px"), noisy_px);
    }
}

TEST_F(Line, HeldOutViewsAreInThePosesAndInNothingElse) {
    configure("[evaluate]\nhold_out_every = 4\n");  // 1, 5 and 9 of nine.
    static_cast<void>(build());
    const Json inspected = Json::parse(lumi("inspect --json " + quoted(package())).out);
    EXPECT_EQ(inspected.at("views").size(), 6U);
    const Json stages = Json::parse(read_whole_text(workspace() / "stages.json")).at("stages");
    EXPECT_EQ(stages.at(1).at("evidence").at("photographs_registered"), 9);
    EXPECT_EQ(stages.at(2).at("evidence").at("cameras_total"), 6);
    EXPECT_EQ(stages.at(3).at("evidence").at("views").size(), 6U);
}

/// Every file of a package with its content.
std::map<std::string, std::string> files_of(const fs::path& package) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(package)) {
        if (!entry.is_regular_file()) continue;
        files[entry.path().lexically_relative(package).string()] = read_whole_text(entry.path());
    }
    return files;
}

/// Depth and drawing as they are by default, on small maps.
constexpr const char* kNarrowDepth = "[depth]\nmax_width_px = 80\n";

TEST_F(Line, PixelsOfHeldOutViewsChangeNoByteOfThePackage) {
    const fs::path photos = scratch_ / "photos";
    fs::copy(scene_->path() / "photos", photos);
    write_whole_text(config_path(),
                     "name = \"box\"\n[capture]\nphotos = \"" + photos.string() +
                         "\"\nimport = \"" + (scene_->path() / "truth" / "sparse").string() +
                         "\"\n[evaluate]\nhold_out = [\"IMG_0005.png\"]\n" + kNarrowDepth);
    EXPECT_EQ(build(), "rrrrr");
    const auto before = files_of(package());

    ColorImage noise = read_color_image(photos / "IMG_0005.png");
    std::uint32_t state = 1;
    for (Rgb8& pixel : noise.pixels()) {
        state = state * 1664525U + 1013904223U;
        pixel = {static_cast<std::uint8_t>(state >> 24U), static_cast<std::uint8_t>(state >> 16U),
                 static_cast<std::uint8_t>(state >> 8U)};
    }
    write_png(photos / "IMG_0005.png", noise);
    EXPECT_EQ(build().substr(0, 1), "r");  // The photograph was read anew.
    EXPECT_EQ(files_of(package()), before);
}

TEST_F(Line, EvaluatesHeldOutViews) {
    configure(
        "[evaluate]\nhold_out = [\"IMG_0005.png\"]\n",
        "[depth]\nimport_folder = \"" + (scene_->path() / "truth" / "depth").string() + "\"\n");
    static_cast<void>(build());
    const Outcome outcome =
        lumi("evaluate --json --mode perpixel --mode lightfield " + quoted(workspace()));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json evaluation =
        Json::parse(read_whole_text(workspace() / "evaluation" / "evaluation.json"));
    EXPECT_EQ(evaluation.at("mode"), "perpixel");
    ASSERT_EQ(evaluation.at("views").size(), 1U);
    EXPECT_EQ(evaluation.at("views").at(0).at("name"), "IMG_0005.png");
    // The middle of a 3 x 3 grid with true poses and depth: only resampling and edges differ.
    EXPECT_GT(evaluation.at("mean").at("psnr_covered_db").get<double>(), 27.0);
    EXPECT_GT(evaluation.at("mean").at("coverage").get<double>(), 0.95);
    EXPECT_TRUE(evaluation.at("modes").contains("lightfield"));
    const ColorImage strip = read_color_image(workspace() / "evaluation" / "IMG_0005.png");
    EXPECT_EQ(strip.width(), 3 * 160 + 2 * 4);
    EXPECT_TRUE(fs::exists(workspace() / "evaluation" / "IMG_0005.flip.png"));
    EXPECT_TRUE(fs::exists(workspace() / "evaluation" / "IMG_0005.ghost.png"));
    EXPECT_THAT(read_whole_text(workspace() / "report.html"), HasSubstr("IMG_0005.png"));

    const Outcome compared = lumi("compare-evaluations --json " + quoted(workspace()) + " " +
                                  quoted(workspace() / "evaluation" / "evaluation.json"));
    ASSERT_EQ(compared.exit_code, 0) << compared.talk;
    const Json psnr =
        Json::parse(compared.out).at("modes").at("perpixel").at("metrics").at("psnr_db");
    EXPECT_EQ(psnr.at("difference"), 0.0);
    EXPECT_EQ(psnr.at("b_is"), "same");
}

TEST_F(Line, OneMeshOfTheSceneDrawsNearlyAsWellAsTheDepthMapsItIsMadeFrom) {
    const std::string held_out = "[evaluate]\nhold_out = [\"IMG_0005.png\"]\n";
    const auto psnr_db = [&] {
        static_cast<void>(build());
        const Outcome outcome =
            lumi("evaluate --json --mode perpixel --no-ghost-energy " + quoted(workspace()));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        return Json::parse(outcome.out).at("mean").at("psnr_db").get<double>();
    };
    configure(held_out, "[depth]\nimport_folder = \"" +
                            (scene_->path() / "truth" / "depth").string() + "\"\n");
    const double from_depth_maps = psnr_db();
    const fs::path mesh = workspace() / "box.ply";
    const std::string fuse = "fuse --json " + quoted(package()) + " --out " + quoted(mesh);
    EXPECT_EQ(lumi(fuse + " --spacing 0.5").exit_code, 2);
    EXPECT_EQ(lumi(fuse + " --agreeing 40 --max-points 10").exit_code, 2);
    EXPECT_FALSE(fs::exists(mesh));
    const Outcome fused = lumi(fuse);
    ASSERT_EQ(fused.exit_code, 0) << fused.talk;
    EXPECT_GT(Json::parse(fused.out).at("faces"), 3000);
    EXPECT_THAT(read_whole_text(mesh), StartsWith("ply\n"));
    configure(held_out, "[depth]\nimport_mesh = \"" + mesh.string() + "\"\n");
    EXPECT_GT(psnr_db(), from_depth_maps - 2.0);
}

TEST_F(Line, MasksAreUsedByDepthDrawingAndEvaluation) {
    const std::string held_out = "[evaluate]\nhold_out = [\"IMG_0005.png\"]\n";
    const fs::path masks = scratch_ / "masks";
    const auto mask_all = [&](int subject_width) {
        GrayImage mask(160, 120);
        for (int y = 0; y < 120; ++y) std::fill_n(mask.row(y), subject_width, std::uint8_t{255});
        for (int i = 1; i <= 9; ++i) {
            write_png(masks / ("IMG_000" + std::to_string(i) + ".png"), mask);
        }
    };
    const auto mean_of_evaluation = [&] {
        const Outcome outcome =
            lumi("evaluate --json --mode perpixel --no-ghost-energy " + quoted(workspace()));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        return Json::parse(outcome.out);
    };
    configure(held_out);
    EXPECT_EQ(build(), "rrrrr");
    const Json unmasked = mean_of_evaluation();
    EXPECT_TRUE(unmasked.at("subject_from").is_null());
    EXPECT_TRUE(unmasked.at("mean").at("psnr_subject_db").is_null());

    mask_all(120);
    configure(held_out, kSparseDepth + ("masks = \"" + masks.string() + "\"\n"));
    EXPECT_EQ(build(), "uuurr");
    const FloatImage inverse_depth =
        read_float_tiff(workspace() / "depth" / "IMG_0001.inverse_depth.tif");
    for (int x = 0; x < 160; ++x) EXPECT_EQ(inverse_depth(x, 60) == 0.0F, x >= 120) << x;
    const Json masked = mean_of_evaluation();
    EXPECT_EQ(masked.at("subject_from"), "drawn masks");
    EXPECT_EQ(masked.at("views").at(0).at("subject_share"), 0.75);
    // What lies beyond the masks is drawn as if it were infinitely far, and the rest as before.
    EXPECT_LT(masked.at("mean").at("psnr_db").get<double>(),
              unmasked.at("mean").at("psnr_db").get<double>() - 3.0);
    EXPECT_GT(masked.at("mean").at("psnr_subject_db").get<double>(),
              masked.at("mean").at("psnr_db").get<double>() + 3.0);
    EXPECT_THAT(read_whole_text(workspace() / "report.html"), HasSubstr("subject (dB)"));

    mask_all(160);
    fs::remove(masks / "IMG_0005.png");
    write_png(masks / "IMG_5.png", GrayImage(160, 120, 255));
    const std::string line =
        "build " + quoted(config_path()) + " --workspace " + quoted(workspace());
    const Outcome noted = lumi(line);
    EXPECT_EQ(noted.exit_code, 0);
    EXPECT_THAT(noted.talk, HasSubstr("nothing is hidden in: IMG_0001.png"));
    EXPECT_THAT(noted.talk, HasSubstr("named like no photograph: IMG_5.png"));
    EXPECT_THAT(noted.talk, HasSubstr("held-out photographs: IMG_0005.png"));
    const auto refusal = [&] {
        const Outcome refused = lumi(line);
        EXPECT_EQ(refused.exit_code, 3);
        return refused.talk;
    };
    write_png(masks / "IMG_0003.png", GrayImage(160, 120));
    EXPECT_THAT(refusal(), HasSubstr("E-MASK-EMPTY"));
    write_png(masks / "IMG_0003.png", GrayImage(120, 160, 255));
    EXPECT_THAT(refusal(), HasSubstr("E-MASK-SIZE"));
    fs::remove(masks / "IMG_0003.png");
    EXPECT_THAT(refusal(), HasSubstr("E-MASK-MISSING: "));
}

TEST_F(Line, DrawsPathsToFramesVideosAndPairs) {
    configure("");
    static_cast<void>(build());
    const std::string draw = "render " + quoted(package()) + " --size 96x64 ";
    const fs::path frames = workspace() / "frames";
    const std::string path = "--path views --frames 3 --out ";
    ASSERT_EQ(lumi(draw + path + quoted(frames)).exit_code, 0);
    EXPECT_EQ(std::distance(fs::directory_iterator(frames), fs::directory_iterator()), 3);
    const ColorImage first = read_color_image(frames / "frame-000001.png");
    EXPECT_EQ(first.width(), 96);

    const fs::path video = workspace() / "tour.mp4";
    const Outcome outcome = lumi(draw + path + quoted(video));
    if (outcome.exit_code == 0) {
        EXPECT_EQ(read_whole_text(video).substr(4, 4), "ftyp");
    } else {
        EXPECT_THAT(outcome.talk, HasSubstr("error E-CHILD-MISSING"));  // No ffmpeg here.
    }

    const fs::path eye = workspace() / "eye.json";
    const std::string text =
        R"({"camera": {"model": "PINHOLE", "width_px": 64, "height_px": 48,
                       "parameters": [60, 60, 32, 24]},
            "cam_from_world": {"rotation_wxyz": [1, 0, 0, 0], "translation": [0, 0, 0]}})";
    write_whole_text(eye, text);
    write_whole_text(workspace() / "path.json", R"({"eyes": [)" + text + "," + text + "]}");
    const fs::path replayed = workspace() / "replayed";
    const std::string from = "render " + quoted(package());
    ASSERT_EQ(
        lumi(from + " --eye " + quoted(eye) + " --out " + quoted(workspace() / "e.png")).exit_code,
        0);
    ASSERT_EQ(
        lumi(from + " --path " + quoted(workspace() / "path.json") + " --out " + quoted(replayed))
            .exit_code,
        0);
    const ColorImage still = read_color_image(workspace() / "e.png");
    EXPECT_EQ(read_color_image(replayed / "frame-000002.png"), still);
    const auto timed = [&](const std::string& time_s) {
        return R"({"time_s": )" + time_s + "," + text.substr(1);
    };
    write_whole_text(workspace() / "timed.json",
                     R"({"eyes": [)" + timed("0") + "," + timed("1.5") + "]}");
    ASSERT_EQ(lumi(from + " --video-fps 4 --path " + quoted(workspace() / "timed.json") +
                   " --out " + quoted(replayed))
                  .exit_code,
              0);
    EXPECT_EQ(std::distance(fs::directory_iterator(replayed), fs::directory_iterator()), 7);

    // The photographs differ in nothing that could be evened out.
    ASSERT_EQ(lumi(from + " --as-taken --no-fade --eye " + quoted(eye) + " --out " +
                   quoted(workspace() / "e.png"))
                  .exit_code,
              0);
    EXPECT_EQ(read_color_image(workspace() / "e.png"), still);

    const fs::path pair = workspace() / "pair.png";
    ASSERT_EQ(
        lumi(from + " --stereo 0.1 --eye " + quoted(eye) + " --out " + quoted(pair)).exit_code, 0);
    EXPECT_EQ(read_color_image(pair).width(), 128);
    write_whole_text(workspace() / "path.json", R"({"eyes": []})");
    EXPECT_EQ(
        lumi(from + " --path " + quoted(workspace() / "path.json") + " --out " + quoted(replayed))
            .exit_code,
        3);
}

/// Of one channel, over the pixels from `left` on that the smaller picture has.
double mean_difference(const ColorImage& wide, int left, const ColorImage& narrow) {
    double sum = 0;
    for (int y = 0; y < narrow.height(); ++y)
        for (int x = 0; x < narrow.width(); ++x)
            sum += std::abs(wide(left + x, y).g - narrow(x, y).g);
    return sum / static_cast<double>(narrow.pixels().size());
}

TEST_F(Line, DrawsAnyShapeOfFrameWithoutStretchingWhatItShows) {
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

TEST_F(Line, DrawsTheDifferenceFromAHeldOutPhotograph) {
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
    EXPECT_THAT(unknown.talk, HasSubstr("E-RENDER-VIEW"));
}

TEST_F(Line, FramesOfAPathReplaceNothingButFrames) {
    configure("");
    ASSERT_EQ(build(), "rrrrr");
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

TEST_F(Line, FoldersOfOneNameDoNotTakeEachOthersPlace) {
    const auto build_folder = [&](const fs::path& folder) {
        return lumi("ingest " + quoted(folder), "cd " + quoted(scratch_.path()) + " &&");
    };
    for (const char* parent : {"a", "b"}) fs::create_directory(scratch_ / parent);
    fs::copy(scene_->path() / "photos", scratch_ / "a/photos", fs::copy_options::recursive);
    fs::copy(scene_->path() / "photos", scratch_ / "b/photos", fs::copy_options::recursive);
    EXPECT_EQ(build_folder(scratch_ / "a/photos").exit_code, 0);
    const Outcome refused = build_folder(scratch_ / "b/photos");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.talk, HasSubstr("E-WORKSPACE-OTHER"));
    EXPECT_EQ(build_folder(scratch_ / "a/photos").exit_code, 0);

    // What a workspace was made with makes it again, from wherever.
    EXPECT_EQ(build_folder(scratch_ / "work/photos/config.toml").exit_code, 0);
    // Nor are results photographs.
    fs::rename(scratch_ / "work", scratch_ / "a/photos/work");
    EXPECT_EQ(build_folder(scratch_ / "a/photos").exit_code, 0);
    const Json stages =
        Json::parse(read_whole_text(scratch_ / "work" / "photos" / "stages.json")).at("stages");
    EXPECT_EQ(stages.at(0).at("evidence").at("photographs"), 9);
}

TEST_F(Line, ScoresAreOfThePackageThatWasRecorded) {
    configure("[evaluate]\nhold_out = [\"IMG_0005.png\"]\n");
    ASSERT_EQ(build(), "rrrrr");
    const fs::path record = workspace() / "pack" / "pack.json";
    const std::string of_first = read_whole_text(record);
    configure("[evaluate]\nhold_out = [\"IMG_0004.png\"]\n");
    ASSERT_EQ(build(), "uurrr");
    const std::string evaluate =
        "evaluate --mode perpixel --no-ghost-energy " + quoted(workspace());
    const auto expect_stale = [&] {
        const Outcome outcome = lumi(evaluate);
        EXPECT_EQ(outcome.exit_code, 3);
        EXPECT_THAT(outcome.talk, HasSubstr("E-EVAL-STALE"));
    };
    const std::string of_second = read_whole_text(record);
    write_whole_text(record, of_first);  // As if the second run had ended before it was recorded.
    expect_stale();
    write_whole_text(record, of_second);
    EXPECT_EQ(lumi(evaluate).exit_code, 0);
    configure("max_width_px = 120\n[evaluate]\nhold_out = [\"IMG_0004.png\"]\n");
    ASSERT_EQ(build("ingest"), "r");
    expect_stale();
}

TEST_F(Line, PacksNoMoreViewsThanAreWanted) {
    const auto views_packed = [&] {
        return Json::parse(lumi("inspect --json " + quoted(package())).out).at("views").size();
    };
    configure("");
    EXPECT_EQ(build(), "rrrrr");
    EXPECT_EQ(views_packed(), 9U);
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(package())) {
        if (entry.is_regular_file()) bytes += entry.file_size();
    }
    const double mib = static_cast<double>(bytes) / (1 << 20);

    configure("[package]\nmax_views = 5\n");
    EXPECT_EQ(build(), "uuuur");
    EXPECT_EQ(views_packed(), 5U);
    EXPECT_EQ(lumi("validate " + quoted(package())).exit_code, 0);

    configure("[package]\nmax_mib = " + std::to_string(0.6 * mib) + "\n");
    EXPECT_EQ(build(), "uuuur");
    EXPECT_GE(views_packed(), 3U);
    EXPECT_LE(views_packed(), 6U);

    configure("[package]\nmax_mib = 0.001\n");
    const Outcome outcome =
        lumi("build " + quoted(config_path()) + " --workspace " + quoted(workspace()));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.talk, HasSubstr("error E-PACK-MIB"));
    EXPECT_GE(views_packed(), 3U);  // The former package stays.
}

TEST_F(Line, DrawsTheCurveOfViewsAgainstError) {
    configure("[evaluate]\nhold_out = [\"IMG_0005.png\", \"IMG_0002.png\"]\n");
    static_cast<void>(build());
    const Outcome outcome = lumi("select --json --random 1 " + quoted(workspace()));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json curve = Json::parse(outcome.out);
    ASSERT_GE(curve.at("curve").size(), 2U);  // 7 and 5 views, perhaps 6; 3 are too few.
    EXPECT_EQ(curve.at("curve").at(0).at("views"), 7);
    EXPECT_EQ(curve.at("curve").back().at("views"), 5);
    EXPECT_GT(curve.at("curve").at(0).at("psnr_db").get<double>(), 15.0);
    EXPECT_GT(curve.at("curve").at(0).at("texture_mib").get<double>(),
              curve.at("curve").at(1).at("texture_mib").get<double>());
    EXPECT_LE(curve.at("auto_views").get<int>(), 7);
    const Json two = Json::parse(lumi("select --json --size 4 " + quoted(workspace())).out);
    ASSERT_EQ(two.at("curve").size(), 2U);
    EXPECT_EQ(two.at("curve").at(1).at("views"), 4);
}

/// Sixteen views of the box so close together that not all are needed.
TEST(CommandLine, AutoPacksAsManyViewsAsAreEnough) {
    const ScratchFolder scratch;
    SceneDescription scene = textured_box_description();
    scene.path.count = 16;
    scene.path.rows = 4;
    scene.path.length_share = 0.1;
    SilentProgress progress;
    synthesize_into(scratch.path(), scene, 0, progress);
    write_whole_text(scratch / "box.toml",
                     "name = \"box\"\n[capture]\nphotos = \"photos\"\nimport = \"truth/sparse\"\n"
                     "[depth]\nimport_folder = \"truth/depth\"\n[evaluate]\nhold_out = "
                     "[\"IMG_0006.png\"]\n[package]\nviews = \"auto\"\n");
    const fs::path workspace = scratch / "work";
    const Outcome build =
        lumi("build " + quoted(scratch / "box.toml") + " --workspace " + quoted(workspace));
    ASSERT_EQ(build.exit_code, 0) << build.talk;
    const std::size_t packed =
        Json::parse(lumi("inspect --json " + quoted(workspace / "box.lumi")).out)
            .at("views")
            .size();
    EXPECT_GE(packed, 4U);
    EXPECT_LT(packed, 15U);
    const Outcome evaluation = lumi("evaluate --json " + quoted(workspace));
    ASSERT_EQ(evaluation.exit_code, 0) << evaluation.talk;
    EXPECT_THAT(read_whole_text(workspace / "report.html"), HasSubstr("IMG_0006"));

    const Outcome flicker =
        lumi("bench-flicker --json --frames 6 --size 40x30 --out " + quoted(scratch / "flicker") +
             " " + quoted(workspace / "box.lumi"));
    ASSERT_EQ(flicker.exit_code, 0) << flicker.talk;
    const Json modes = Json::parse(flicker.out).at("modes");
    EXPECT_EQ(modes.size(), 5U);
    EXPECT_EQ(modes.at("perpixel").at("changes").size(), 5U);
    EXPECT_GT(modes.at("perpixel").at("mean_change").get<double>(), 0.0);
    EXPECT_THAT(read_whole_text(scratch / "flicker" / "flicker.svg"), HasSubstr("</svg>"));
    EXPECT_TRUE(fs::exists(scratch / "flicker" / "jump-perpixel.png"));
    EXPECT_EQ(lumi("bench-flicker").exit_code, 2);

    const Outcome bench = lumi("bench --json --frames 2 --size 40x30 --occlusion-share " +
                               quoted(workspace / "box.lumi"));
    ASSERT_EQ(bench.exit_code, 0) << bench.talk;
    EXPECT_TRUE(Json::parse(bench.out).contains("base_device_ms"));
    const Json timed = Json::parse(bench.out).at("modes");
    EXPECT_GT(timed.at("perpixel").at("cpu_ratio").get<double>(), 0.0);
    EXPECT_TRUE(timed.at("perpixel").at("occlusion_share").is_number());
    EXPECT_TRUE(timed.at("lightfield").at("occlusion_share").is_null());
}

TEST_F(Line, PlansWhereToPhotographNext) {
    configure("");
    EXPECT_EQ(build("poses"), "rr");
    const Outcome outcome = lumi("plan --json --suggestions 2 " + quoted(workspace()));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json plan = Json::parse(outcome.out);
    ASSERT_EQ(plan.at("suggestions").size(), 2U);
    EXPECT_GT(plan.at("suggestions").at(0).at("predicted_error_px").get<double>(), 0.0);
    EXPECT_EQ(plan.at("suggestions").at(0).at("from").size(), 2U);
    EXPECT_THAT(read_whole_text(workspace() / "plan" / "plan.svg"), HasSubstr("</svg>"));
    EXPECT_THAT(lumi("plan --wish 0.01 " + quoted(workspace())).out, HasSubstr("0.01 px"));
}

TEST(CommandLine, MeasuresTheRivalsOnAPaperScene) {
    const Outcome outcome = lumi(
        "bench-rivals --json --scene coke --size 64 --frames 2 --held-out 2 --flicker-frames 2");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json scene = Json::parse(outcome.out).at("scenes").at(0);
    EXPECT_EQ(scene.at("photographs"), 33);
    std::map<std::string, double> covered_db;
    for (const Json& rival : scene.at("rivals"))
        covered_db.try_emplace(rival.at("method"), rival.at("psnr_covered_db"));
    for (const char* method :
         {"lightfield", "heigl", "adaptive", "paper2001", "two-plane lightfield",
          "unstructured lumigraph", "view-dependent texture", "forward warping"})
        EXPECT_GT(covered_db[method], 10.0) << method;
    // What depth is worth, and what resampling costs.
    EXPECT_GT(covered_db["perpixel"], covered_db["lightfield"] + 3);
    EXPECT_GT(covered_db["adaptive"], covered_db["two-plane adaptive"]);
    EXPECT_EQ(lumi("bench-rivals --scene pepsi").exit_code, 2);
}

TEST(CommandLine, MeasuresTheCameraMeshOverRandomCaptures) {
    const Outcome outcome = lumi("bench-mesh --json --captures 3 --rays 300 --most-cameras 1000");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json result = Json::parse(outcome.out);
    EXPECT_EQ(result.at("cameras_kept"), result.at("cameras"));
    EXPECT_EQ(result.at("rays_with_one_face"), 300);
    ASSERT_EQ(result.at("weights").size(), 4U);
    EXPECT_LT(result.at("weights").at(0).at("largest_inconsistency").get<double>(), 1e-9);
    EXPECT_LT(result.at("weights").at(0).at("largest_jump").get<double>(), 1e-6);
    EXPECT_GT(result.at("weights").at(1).at("largest_inconsistency").get<double>(), 0.01);
    EXPECT_GT(result.at("weights").at(2).at("largest_inconsistency").get<double>(), 0.01);
    EXPECT_EQ(result.at("weights").at(0).at("inconsistency_shares").at(0), 1.0);
    EXPECT_EQ(result.at("weights").at(3).at("inconsistency_shares").size(),
              result.at("inconsistency_bin_ends").size());
}

TEST_F(Line, EvaluateSaysWhatToSetWhenNothingIsHeldOut) {
    configure("");
    static_cast<void>(build());
    const Outcome outcome = lumi("evaluate " + quoted(workspace()));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.talk, HasSubstr("error E-EVAL-NOHOLDOUT"));
    EXPECT_THAT(outcome.talk, HasSubstr("hold_out_every = 8"));
}

TEST_F(Line, AFailureIsWrittenDownAndTheFormerPackageStays) {
    configure("");
    static_cast<void>(build());
    const std::string before = read_whole_text(package() / "lumigraph.json");
    configure("[evaluate]\nhold_out = [\"no.png\"]\n");
    const Outcome outcome =
        lumi("build " + quoted(config_path()) + " --workspace " + quoted(workspace()));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.talk, HasSubstr("error E-EVAL-NAME"));
    const Json stages = Json::parse(read_whole_text(workspace() / "stages.json"));
    EXPECT_EQ(stages.at("failure").at("code"), "E-EVAL-NAME");
    EXPECT_THAT(read_whole_text(workspace() / "report.html"), HasSubstr("E-EVAL-NAME"));
    EXPECT_EQ(read_whole_text(package() / "lumigraph.json"), before);
}

TEST_F(Line, TheSameBytesForAnyNumberOfThreads) {
    configure("", kNarrowDepth, "");
    std::vector<std::string> manifests;
    for (const char* threads : {"1", "3"}) {
        const fs::path folder = scratch_ / threads;
        ASSERT_EQ(lumi("build " + quoted(config_path()) + " --workspace " + quoted(folder) +
                       " --threads " + threads)
                      .exit_code,
                  0);
        manifests.push_back(read_whole_text(folder / "box.lumi" / "lumigraph.json"));
    }
    EXPECT_EQ(manifests[0], manifests[1]);  // It has the checksum of every other file.
}

}  // namespace
}  // namespace lumi
