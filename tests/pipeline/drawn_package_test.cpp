#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "tests/pipeline/built_program.h"
#include "tests/pipeline/told_choices.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

/// A package of the textured box with its true poses, and commands that draw it.
class DrawnPackage : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<ScratchFolder>();
        SilentProgress progress;
        synthesize_into(*folder_ / "scene", textured_box_description(), 0, progress);
        write_whole_text(*folder_ / "box.toml",
                         "name = \"box\"\nworkspace = \"work\"\n[capture]\n"
                         "photos = \"scene/photos\"\nimport = \"scene/truth/sparse\"\n"
                         "[evaluate]\nhold_out = [\"IMG_0005.png\"]\n" +
                             std::string(kSparseDepth) + kToldDrawing);
        ASSERT_EQ(lumi("build " + quoted(*folder_ / "box.toml")).exit_code, 0);
    }
    static void TearDownTestSuite() { folder_.reset(); }

    static std::string package() { return quoted(*folder_ / "work" / "box.lumi"); }
    /// What `lumi render` draws by these arguments.
    [[nodiscard]] ColorImage drawn(const std::string& arguments) const {
        const Outcome outcome = lumi("render " + package() + " " + arguments + " --out " +
                                     quoted(scratch_ / "drawn.png"));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        return read_color_image(scratch_ / "drawn.png");
    }

    static std::unique_ptr<ScratchFolder> folder_;
    ScratchFolder scratch_;
};

std::unique_ptr<ScratchFolder> DrawnPackage::folder_;

TEST_F(DrawnPackage, AnEyeIsDrawnAsItsFileSaysUnlessTheLineSaysOtherwise) {
    // Behind the cameras and beside them, so that much is a guess.
    const Json eye{
        {"camera",
         {{"model", "PINHOLE"},
          {"width_px", 64},
          {"height_px", 48},
          {"parameters", {40, 40, 32, 24}}}},
        {"cam_from_world", {{"rotation_wxyz", {1, 0, 0, 0}}, {"translation", {0, 0, 1}}}}};
    const auto by_file = [&](const Json& said, const std::string& more = "") {
        Json file = eye;
        file.update(said);
        write_whole_text(scratch_ / "eye.json", file.dump());
        return drawn("--eye " + quoted(scratch_ / "eye.json") + more);
    };
    const ColorImage usual = by_file(Json::object());
    const ColorImage plain = by_file(Json::object(), " --mode lightfield");
    const ColorImage depth = by_file(Json::object(), " --debug depth");
    const ColorImage black = by_file(Json::object(), " --black-surroundings");
    const ColorImage faded = by_file(Json::object(), " --fade");
    EXPECT_NE(usual, plain);
    EXPECT_NE(usual, depth);
    EXPECT_NE(usual, black);
    EXPECT_NE(black, faded);

    EXPECT_EQ(by_file({{"mode", "lightfield"}}), plain);
    EXPECT_EQ(by_file({{"debug_picture", "depth"}}), depth);
    EXPECT_EQ(by_file({{"guess_surroundings", false}}), black);
    EXPECT_EQ(by_file({{"fade_beyond_capture", true}}), faded);

    EXPECT_EQ(by_file({{"mode", "lightfield"}}, " --mode perpixel"), usual);
    EXPECT_EQ(by_file({{"debug_picture", "depth"}}, " --debug none"), usual);
    EXPECT_EQ(by_file({{"fade_beyond_capture", true}}, " --no-fade"), usual);
    const Json told =
        Json::parse(lumi("--json render " + package() + " --eye " + quoted(scratch_ / "eye.json") +
                         " --out " + quoted(scratch_ / "drawn.png"))
                        .out);
    EXPECT_EQ(told.at("mode"), "perpixel");
}

TEST_F(DrawnPackage, ADebugPictureThatIsBlackIsExplained) {
    const auto talk_of = [&](const std::string& mode) {
        return lumi("render " + package() +
                    " --size 32x24 --view IMG_0001 --debug occlusion --mode " + mode + " --out " +
                    quoted(scratch_ / "drawn.png"))
            .talk;
    };
    EXPECT_THAT(talk_of("lightfield"), HasSubstr("lightfield knows no occlusion"));
    EXPECT_THAT(talk_of("adaptive"), testing::Not(HasSubstr("black")));
}

TEST_F(DrawnPackage, HelpDescribesTheFileOfAnEye) {
    const std::string help = lumi("render --help").out;
    for (const char* key : {"\"camera\"", "\"cam_from_world\"", "\"rotation_wxyz\"", "\"mode\"",
                            "\"debug_picture\"", "\"as_taken\""}) {
        EXPECT_THAT(help, HasSubstr(key));
    }
}

TEST_F(DrawnPackage, FiguresAreComparedWithTheBaselineThatTheyReplace) {
    const std::string measure = "--json regression " + quoted(*folder_ / "work") +
                                " --frames 2 --rounds 1 --write " + quoted(scratch_ / "f.json");
    ASSERT_EQ(lumi(measure).exit_code, 0);
    const Json now = Json::parse(read_whole_text(scratch_ / "f.json"));

    // A baseline in which every error was nearly nothing.
    Json better = now;
    for (Json& figure : better.at("figures")) figure["value"] = 1e-6;
    write_whole_text(scratch_ / "f.json", better.dump());
    const Outcome outcome = lumi(measure + " --baseline " + quoted(scratch_ / "f.json"));
    EXPECT_EQ(outcome.exit_code, 5) << outcome.talk;
    EXPECT_FALSE(Json::parse(outcome.out).at("moves").empty());
    EXPECT_NE(read_whole_text(scratch_ / "f.json"), better.dump()) << "it was to be written anew";
}

TEST_F(DrawnPackage, WhatEndsAPathIsNotToldToBeKept) {
    const Outcome outcome = lumi("render " + package() + " --path views --frames 100000 --out " +
                                     quoted(scratch_ / "frames"),
                                 "timeout --foreground --preserve-status --signal=INT 2");
    EXPECT_EQ(outcome.exit_code, 130) << outcome.talk;
    EXPECT_THAT(outcome.talk, HasSubstr("error E-INTERRUPTED"));
    EXPECT_THAT(outcome.talk, Not(HasSubstr("stages")));
    EXPECT_FALSE(fs::exists(scratch_ / "frames"));
}

TEST_F(DrawnPackage, IsDrawnByTheMethodsOfOthersBesideLumis) {
    const std::string workspace = quoted(*folder_ / "work");
    const Outcome outcome = lumi("--json evaluate " + workspace + " --mode adaptive --rivals");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json evaluation = Json::parse(outcome.out);
    EXPECT_GT(evaluation.at("mean").at("cpu_ms").get<double>(), 0.0);
    EXPECT_TRUE(evaluation.at("modes").contains("heigl"));
    const Json& rivals = evaluation.at("rivals");
    for (const char* method : {"unstructured lumigraph", "view-dependent texture",
                               "forward warping", "two-plane lightfield", "two-plane adaptive"}) {
        EXPECT_GT(rivals.at("methods").at(method).at("mean").at("psnr_db").get<double>(), 10.0)
            << method;
    }
    EXPECT_TRUE(rivals.at("left_out").contains("spherical"));
    // Modes and methods on the same pixels.
    const Json& common = rivals.at("common_pixels");
    EXPECT_GT(common.at("share").get<double>(), 0.2);
    for (const char* method : {"adaptive", "heigl", "forward warping", "unstructured lumigraph"})
        EXPECT_GT(common.at("psnr_db").at(method).get<double>(), 10.0) << method;
    EXPECT_TRUE(
        fs::exists(*folder_ / "work" / "evaluation" / "IMG_0005.unstructured-lumigraph.png"));
    const std::string report = read_whole_text(*folder_ / "work" / "report.html");
    EXPECT_THAT(report, HasSubstr("forward warping"));
    EXPECT_THAT(report, HasSubstr("Not drawn: spherical."));
    EXPECT_EQ(lumi("evaluate " + workspace + " --leave-one-out --rivals").exit_code, 2);
}

TEST_F(DrawnPackage, FramesAreCountedInLookupsAndBytes) {
    const Outcome outcome = lumi("--json bench " + package() + " --frames 2 --size 40x30");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json bench = Json::parse(outcome.out);
    for (const auto& [mode, cost] : bench.at("modes").items()) {
        EXPECT_GE(cost.at("p95_cpu_ms"), cost.at("cpu_ms")) << mode;
        EXPECT_GT(cost.at("uploaded_bytes").get<double>(), 0.0) << mode;
        EXPECT_EQ(cost.at("fetches_per_pixel").is_null(),
                  bench.at("base_fetches_per_pixel").is_null());
    }
}

TEST_F(DrawnPackage, TimeBudgetsNeedTwoHeldOutPhotographs) {
    const Outcome outcome = lumi("bench " + package() + " --fps 10,20");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.talk, HasSubstr("E-BENCH-HOLDOUT"));
    EXPECT_EQ(lumi("bench " + package() + " --fps 10 --mode adaptive").exit_code, 2);
}

}  // namespace
}  // namespace lumi
