#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/pipeline/drawn_package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

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

TEST_F(DrawnPackage, ThePapersParametersAreTheUsersWhereTheyMeanSomething) {
    const auto paper = [&](const std::string& more) {
        return drawn("--view IMG_0005.png --mode paper2001 --debug grid " + more);
    };
    const ColorImage usual = paper("");
    EXPECT_EQ(paper("--min-triangle 6 --max-triangle 96 --depth-threshold 0.02"), usual);
    EXPECT_NE(paper("--min-triangle 24"), usual);
    EXPECT_NE(paper("--max-triangle 16"), usual);
    EXPECT_NE(paper("--depth-threshold 0.2"), usual);
    const std::string adaptive = "--view IMG_0005.png --mode adaptive --debug grid";
    EXPECT_NE(drawn(adaptive + " --max-triangle 16"), drawn(adaptive));

    for (const char* options :
         {"--min-triangle 6", "--mode lightfield --max-triangle 50",
          "--mode adaptive --depth-threshold 0.1", "--mode paper2001 --min-triangle 100",
          "--mode paper2001 --min-triangle nan", "--mode paper2001 --min-triangle 0"}) {
        const Outcome outcome = lumi("render " + package() + " --view IMG_0005.png " + options +
                                     " --out " + quoted(scratch_ / "x.png"));
        EXPECT_EQ(outcome.exit_code, 2) << options;
    }
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
