#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/regression/version_figures.h"
#include "pipeline/workspace/json_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::StartsWith;

TEST(Regression, SaysWhatMovedBeyondTheNoiseOfBoth) {
    const VersionFigures before{{"error.a.flip", {0.100, 0.001, false}},
                                {"error.a.psnr_db", {30.0, 0.1, true}},
                                {"ratio.a", {3.0, 0.2, false}},
                                {"ratio.gone", {3.0, 0.2, false}}};
    const VersionFigures now{{"error.a.flip", {0.103, 0.001, false}},
                             {"error.a.psnr_db", {30.5, 0.1, true}},
                             {"ratio.a", {3.35, 0.2, false}},
                             {"ratio.new", {1.0, 0.2, false}}};
    const FigureComparison comparison = compare_figures(before, now);
    EXPECT_EQ(comparison.compared, 3U);
    EXPECT_THAT(comparison.only_before, ElementsAre("ratio.gone"));
    EXPECT_THAT(comparison.only_now, ElementsAre("ratio.new"));
    const std::vector<FigureMove>& moves = comparison.moves;
    ASSERT_EQ(moves.size(), 2U);
    EXPECT_EQ(moves[0].name, "error.a.flip");
    EXPECT_FALSE(moves[0].is_better);
    EXPECT_EQ(moves[1].name, "error.a.psnr_db");
    EXPECT_TRUE(moves[1].is_better);
    EXPECT_TRUE(compare_figures(now, now).moves.empty());
}

/// The code and the words of the refusal; empty where there is none.
std::string refusal(const VersionFigures& before, const VersionFigures& now) {
    try {
        refuse_regression(compare_figures(before, now), "base.json");
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kPartialResult);
        return error.code() + ": " + error.what();
    }
}

TEST(Regression, WhatTheBaselineHasMustBeMeasuredAgain) {
    const VersionFigures one{{"ratio.a", {3.0, 0.2, false}}};
    const VersionFigures two{{"ratio.a", {3.0, 0.2, false}}, {"ratio.b", {3.0, 0.2, false}}};
    EXPECT_EQ(refusal(one, one), "");
    EXPECT_EQ(refusal(one, two), "") << "a new figure is no regression";
    EXPECT_EQ(refusal(two, one),
              "E-REGRESSION-MISSING: base.json: 1 of its 2 figures were measured again, not "
              "ratio.b");
    EXPECT_THAT(refusal({}, two), StartsWith("E-REGRESSION-MISSING: base.json: 0 of its 0"));
}

TEST(Regression, AWorseFigureIsRefusedAndNoNumberIsWorse) {
    const VersionFigures before{{"ratio.a", {3.0, 0.2, false}}};
    const auto now = [](double value) { return VersionFigures{{"ratio.a", {value, 0.2, false}}}; };
    EXPECT_EQ(refusal(before, now(2.0)), "");
    EXPECT_EQ(refusal(before, now(4.0)), "E-REGRESSION-WORSE: 1 figure is worse than in base.json");
    EXPECT_THAT(refusal(before, now(std::numeric_limits<double>::quiet_NaN())),
                StartsWith("E-REGRESSION-WORSE"));
}

TEST(Regression, FiguresAreReadBackAsTheyWereWritten) {
    const ScratchFolder scratch;
    const MeasuredVersion version{
        {"demo", 768, 512, {"a.png", "b.png"}}, 20, 3, {{"ratio.a", {1.0 / 3.0, 0.1, false}}}};
    write_json_file(scratch / "b.json", version_json(version));
    const MeasuredVersion again = read_version(scratch / "b.json");
    EXPECT_EQ(again.figures.at("ratio.a").value, 1.0 / 3.0);
    EXPECT_EQ(again.scene, version.scene);
    EXPECT_EQ(again.frames, 20);
    EXPECT_EQ(again.rounds, 3);
    write_whole_text(scratch / "bad.json", "{\"schema_version\": 2, \"figures\": {}}");
    EXPECT_THROW(static_cast<void>(read_version(scratch / "bad.json")), Error);
}

/// The code of what is thrown, and its words.
template <class Work>
std::string thrown_by(const Work& work) {
    try {
        work();
        return "";
    } catch (const Error& error) {
        return error.code() + ": " + error.what();
    }
}

TEST(Regression, FiguresOfAnotherSceneAreNotCompared) {
    const MeasuredScene scene{"demo", 768, 512, {"a.png", "b.png"}};
    EXPECT_EQ(thrown_by([&] { expect_same_scene(scene, scene, "base.json"); }), "");
    for (const MeasuredScene& other : {MeasuredScene{"cube", 768, 512, {"a.png", "b.png"}},
                                       MeasuredScene{"demo", 384, 256, {"a.png", "b.png"}},
                                       MeasuredScene{"demo", 768, 512, {"a.png", "c.png"}}}) {
        EXPECT_THAT(
            thrown_by([&] { expect_same_scene(scene, other, "base.json"); }),
            StartsWith("E-REGRESSION-OTHER: base.json: is of demo (768x512, a.png, b.png)"));
    }
    MeasuredScene many = scene;
    for (int i = 0; i < 30; ++i) many.views.push_back("c" + std::to_string(i) + ".png");
    MeasuredScene others = many;
    others.views[20] = "d.png";
    EXPECT_THAT(thrown_by([&] { expect_same_scene(many, others, "base.json"); }),
                EndsWith(": c18.png stands there, and here d.png"));
    const ScratchFolder scratch;
    write_whole_text(scratch / "old.json", "{\"schema_version\": 1, \"figures\": {}}");
    EXPECT_THAT(thrown_by([&] { static_cast<void>(read_version(scratch / "old.json")); }),
                StartsWith("E-REGRESSION-OTHER"));
    const MeasuredVersion ours =
        read_version(std::filesystem::path(LUMI_SOURCE_DIR) / "configs/bench-baseline.json");
    EXPECT_EQ(ours.scene.name, "demo") << "what ./run bench measures";
}

TEST(Regression, FiguresThatWereTimedOtherwiseAreNotCompared) {
    const MeasuredVersion version{{"demo", 768, 512, {"a.png"}}, 20, 3, {}};
    EXPECT_EQ(thrown_by([&] { expect_same_timing(version, 20, 3, "base.json"); }), "");
    for (const auto& [frames, rounds] : {std::pair(2, 3), std::pair(20, 1)})
        EXPECT_THAT(thrown_by([&, frames = frames, rounds = rounds] {
                        expect_same_timing(version, frames, rounds, "base.json");
                    }),
                    StartsWith("E-REGRESSION-OTHER: base.json: was measured with --frames 20 "
                               "--rounds 3, and not with "));
}

}  // namespace
}  // namespace lumi
