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
    EXPECT_EQ(refusal(before, now(4.0)),
              "E-REGRESSION-WORSE: 1 figures are worse than in base.json");
    EXPECT_THAT(refusal(before, now(std::numeric_limits<double>::quiet_NaN())),
                StartsWith("E-REGRESSION-WORSE"));
}

TEST(Regression, FiguresAreReadBackAsTheyWereWritten) {
    const ScratchFolder scratch;
    const VersionFigures figures{{"ratio.a", {1.0 / 3.0, 0.1, false}}};
    write_json_file(scratch / "b.json", version_figures_json(figures));
    const VersionFigures again = read_version_figures(scratch / "b.json");
    EXPECT_EQ(again.at("ratio.a").value, 1.0 / 3.0);
    write_whole_text(scratch / "bad.json", "{\"schema_version\": 2, \"figures\": {}}");
    EXPECT_THROW(static_cast<void>(read_version_figures(scratch / "bad.json")), Error);
}

}  // namespace
}  // namespace lumi
