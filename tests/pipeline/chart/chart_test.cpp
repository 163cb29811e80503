#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/chart/chart_files.h"
#include "pipeline/chart/chart_page.h"
#include "pipeline/chart/growth_files.h"
#include "pipeline/chart/label_choice.h"
#include "pipeline/chart/pareto_front.h"
#include "pipeline/chart/plot.h"
#include "pipeline/chart/power_law.h"
#include "pipeline/chart/sweep.h"
#include "pipeline/chart/sweep_plots.h"
#include "pipeline/text/csv.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(ParetoFront, KeepsWhatNothingBeats) {
    EXPECT_THAT(pareto_front({{1, 9}, {2, 5}, {3, 7}, {4, 5}, {5, 1}, {0.5, 20}}),
                ElementsAre(5, 0, 1, 4));
    EXPECT_THAT(pareto_front({{1, 1}, {1, 1}, {1, 2}}), ElementsAre(0));
    EXPECT_THAT(pareto_front({}), ElementsAre());
}

TEST(Csv, QuotesWhatNeedsIt) {
    EXPECT_EQ(csv_row({"a", "b,c", "say \"x\"", "two\nlines"}),
              "a,\"b,c\",\"say \"\"x\"\"\",\"two\nlines\"\n");
}

TEST(PowerLaw, IsFoundInItsOwnPoints) {
    std::vector<double> y;
    const std::vector<double> x{10, 20, 40, 80};
    for (const double value : x) y.push_back(0.5 * std::pow(value, 1.7));
    const PowerLaw law = *fit_power_law(x, y);
    EXPECT_NEAR(law.exponent, 1.7, 1e-12);
    EXPECT_NEAR(law.factor, 0.5, 1e-12);
    EXPECT_NEAR(law.exponent_error, 0.0, 1e-9);
    EXPECT_FALSE(fit_power_law({5, 5}, {1, 2}).has_value());
    EXPECT_FALSE(fit_power_law({5, 6}, {0, 2}).has_value());
}

GrowthResult linear_growth() {
    GrowthResult growth;
    for (const int count : {10, 20, 40}) {
        growth.by_photographs.push_back({"ingest", count, 0.4, 0.1 * count, 0.1 * count, 100.0});
        growth.by_photographs.push_back(
            {"poses", count, 0.4, 0.01 * count * count, 1.0, 50.0 + count});
    }
    return growth;
}

TEST(Growth, TellsTheExponentOfEveryStage) {
    const Json json = growth_json(linear_growth());
    const Json& exponents = json.at("by_photographs").at("exponents");
    EXPECT_NEAR(exponents.at("ingest").at("cpu").at("exponent").get<double>(), 1.0, 1e-9);
    EXPECT_NEAR(exponents.at("poses").at("cpu").at("exponent").get<double>(), 2.0, 1e-9);
    EXPECT_NEAR(exponents.at("ingest").at("memory").at("exponent").get<double>(), 0.0, 1e-9);
    const std::vector<NamedPlot> plots = growth_plots(linear_growth());
    ASSERT_EQ(plots.size(), 2U);  // Nothing was measured against size.
    EXPECT_EQ(plots[0].plot.series.at(1).name, "poses ~ n^2.00");
}

/// A configuration file with a sweep.
class SweepFile : public testing::Test {
 protected:
    Sweep read(const std::string& more) {
        const std::filesystem::path path = scratch_ / "capture.toml";
        write_whole_text(path, "[capture]\nphotos = \"p\"\nmin_photographs = 3\n" + more);
        return read_sweep(path);
    }
    ScratchFolder scratch_;
};

TEST_F(SweepFile, SaysHowASettingIsWrittenWhereOneStandsInQuotationMarks) {
    try {
        static_cast<void>(read("[sweep]\n\"depth.model\" = [\"sparse\", \"sweep\"]\n"));
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-CONFIG-KEY");
        EXPECT_THAT(error.advice(), testing::HasSubstr("without quotation marks: depth.model = ["));
    }
}

TEST_F(SweepFile, MakesEveryCombinationAndChangesNothingElse) {
    const Sweep sweep = read(
        "[sweep]\nmodes = [\"perpixel\"]\nrepeats = 2\n"
        "depth.model = [\"sparse\", \"sweep\"]\ncapture.max_width_px = [384, 512, 768]\n");
    EXPECT_EQ(sweep.name, "capture");
    EXPECT_EQ(sweep.repeats, 2);
    EXPECT_THAT(sweep.modes, ElementsAre(RenderMode::kPerPixel));
    ASSERT_EQ(sweep.axes.size(), 2U);
    EXPECT_EQ(sweep.axes[0].setting, "capture.max_width_px");
    EXPECT_THAT(sweep.axes[1].values, ElementsAre("sparse", "sweep"));
    ASSERT_EQ(sweep.variants.size(), 6U);
    EXPECT_EQ(sweep.variants[0].label, "384 sparse");
    EXPECT_EQ(sweep.variants[5].label, "768 sweep");
    for (const Variant& variant : sweep.variants) {
        EXPECT_EQ(variant.config.ingest.min_photographs, 3);
        EXPECT_EQ(variant.config.photographs_or_video, scratch_ / "p");
    }
    EXPECT_EQ(sweep.variants[3].config.ingest.max_width_px, 512);
    EXPECT_EQ(sweep.variants[3].config.depth.model, "sweep");
    EXPECT_THAT(sweep.variants[3].choice, ElementsAre(1U, 1U));
    // What decides the stages before depth does not depend on the depth model.
    EXPECT_EQ(sweep.variants[4].config.stage_parameters.at("poses"),
              sweep.variants[5].config.stage_parameters.at("poses"));
    EXPECT_NE(sweep.variants[4].config.stage_parameters.at("depth"),
              sweep.variants[5].config.stage_parameters.at("depth"));
}

TEST_F(SweepFile, WithoutASweepDepthModelsAndSizesAreTried) {
    const Sweep sweep = read("max_width_px = 800\n");
    ASSERT_EQ(sweep.axes.size(), 2U);
    EXPECT_EQ(sweep.axes[0].setting, "depth.model");
    EXPECT_GE(sweep.axes[0].values.size(), 2U);
    EXPECT_THAT(sweep.axes[1].values, ElementsAre("400", "600", "800"));
    EXPECT_GE(sweep.modes.size(), 2U);
}

TEST_F(SweepFile, PhotographsAreNotEnlargedToTrySizes) {
    std::filesystem::create_directories(scratch_ / "p");
    for (const char* const name : {"one.png", "two.png"}) {
        write_png(scratch_ / "p" / name, ColorImage(200, 120));
    }
    EXPECT_THAT(read("max_width_px = 800\n").axes.at(1).values, ElementsAre("100", "150", "200"));
    EXPECT_THAT(read("max_width_px = 0\n").axes.at(1).values, ElementsAre("100", "150", "200"));
    EXPECT_THAT(read("max_width_px = 160\n").axes.at(1).values, ElementsAre("80", "120", "160"));
    // Three times the same size would be three times the work.
    EXPECT_THAT(read("max_width_px = 64\n").axes.at(1).values, ElementsAre("64"));
}

TEST_F(SweepFile, AllStandsForEveryDepthModel) {
    const Sweep sweep = read("[sweep]\ndepth.model = [\"all\"]\n");
    const std::vector<std::string>& models = sweep.axes.at(0).values;
    EXPECT_NE(std::find(models.begin(), models.end(), "sparse"), models.end());
    EXPECT_NE(std::find(models.begin(), models.end(), "sweep"), models.end());
}

TEST_F(SweepFile, WhatIsWrongNamesFileAndKey) {
    const auto error_of = [&](const std::string& more) -> std::string {
        try {
            static_cast<void>(read(more));
        } catch (const Error& error) {
            return error.code() + " " + error.what();
        }
        return "nothing";
    };
    EXPECT_THAT(error_of("[sweep]\ndepth.model = \"sparse\"\n"), HasSubstr("E-CONFIG-VALUE"));
    EXPECT_THAT(error_of("[sweep]\ndepth.model = []\n"), HasSubstr("sweep.depth.model"));
    EXPECT_THAT(error_of("[sweep]\ndepth.modle = [1]\n"), HasSubstr("E-CONFIG-KEY"));
    EXPECT_THAT(error_of("[sweep]\nmodes = [\"no\"]\n"), HasSubstr("modes"));
    EXPECT_THAT(error_of("[sweep]\nrepeats = 0\n"), HasSubstr("repeats"));
    EXPECT_THAT(error_of("[sweep]\nrepeat = 2\n"), HasSubstr("E-CONFIG-KEY"));
    std::string many = "[sweep]\n";
    for (const char* key : {"depth.max_width_px", "depth.max_neighbours", "capture.max_width_px"}) {
        many += std::string(key) + " = [100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110]\n";
    }
    EXPECT_THAT(error_of(many), HasSubstr("E-CHART-SIZE"));
}

TEST_F(SweepFile, IsAConfigurationLikeAnyOther) {
    const std::filesystem::path path = scratch_ / "c.toml";
    write_whole_text(path, "[capture]\nphotos = \"p\"\n[sweep]\ndepth.model = [\"sparse\"]\n");
    EXPECT_EQ(load_build_config(path).resolved_toml.find("[sweep]"), std::string::npos);
}

/// A sweep of 2 x 2 that was measured: the second depth model is slower and better.
ChartResult measured_sweep() {
    ChartResult result;
    result.sweep.name = "demo <b>";
    result.sweep.axes = {{"capture.max_width_px", {"384", "768"}}, {"depth.model", {"a", "b"}}};
    result.sweep.modes = {RenderMode::kPerPixel};
    result.sweep.repeats = 2;
    result.shared_views = {"x.jpg", "y.jpg"};
    result.work = {50.0, 200.0};
    for (std::size_t width = 0; width < 2; ++width) {
        for (std::size_t depth = 0; depth < 2; ++depth) {
            result.sweep.variants.push_back(
                {{width, depth}, std::to_string(width) + " " + std::to_string(depth), {}});
            MeasuredVariant variant;
            const double poses_s = width == 0 ? 10.0 : 20.0;
            const double depth_s = depth == 0 ? 1.0 : 5.0;
            variant.stages = {{"poses", {poses_s, poses_s + 1}, {poses_s, poses_s}},
                              {"depth", {depth_s, depth_s + 0.5}, {depth_s, depth_s}}};
            variant.package_mib = width == 0 ? 5.0 : 20.0;
            ViewScore view{.name = "x.jpg", .psnr_db = 25.0 + static_cast<double>(depth), .ms = 10};
            view.flip = 0.2 - 0.05 * static_cast<double>(depth) - 0.02 * static_cast<double>(width);
            ViewScore other = view;
            other.name = "y.jpg";
            other.flip += 0.01;
            variant.scores = {{RenderMode::kPerPixel, {view, other}, {}, {}}};
            result.variants.push_back(variant);
        }
    }
    // Slower and worse than what stands before it.
    result.variants[2].scores[0].views[0].flip = 0.5;
    return result;
}

TEST(ChartPoints, HaveTheMedianTimesAndTheMeanErrors) {
    const std::vector<ChartPoint> points = points_of(measured_sweep());
    ASSERT_EQ(points.size(), 4U);
    EXPECT_DOUBLE_EQ(points[1].build_cpu_s, 11.0 + 5.5);
    EXPECT_DOUBLE_EQ(points[1].mean.flip, 0.155);
    EXPECT_THAT(front_by_build_time(points), ElementsAre(0, 1, 3));
}

TEST(ChartJson, SaysHowMuchCameFromTheCache) {
    const Json json = chart_json(measured_sweep());
    EXPECT_DOUBLE_EQ(json.at("work").at("cached_share"), 0.75);
    EXPECT_EQ(json.at("variants").size(), 4U);
    EXPECT_EQ(json.at("variants").at(1).at("settings").at("depth.model"), "b");
}

TEST(SweepPlots, AStageIsComparedWithAllElseAsInTheBestPoint) {
    const std::vector<NamedPlot> plots = plots_of(measured_sweep());
    std::vector<std::string> names;
    for (const NamedPlot& plot : plots) names.push_back(plot.name);
    EXPECT_THAT(names, ElementsAre("end-to-end", "drawing", "size", "stage-ingest", "stage-depth"));
    const std::vector<PlotMark>& marks = plots[4].plot.series.at(0).marks;
    ASSERT_EQ(marks.size(), 2U);  // The best has width 768: two depth models there.
    EXPECT_DOUBLE_EQ(marks[0].x, 1.5);
    EXPECT_DOUBLE_EQ(marks[0].x_range->low, 1.0);
    EXPECT_EQ(marks[1].label, "b");
}

TEST(SweepPlots, WhatIsBeatenIsFaintAndTheFrontIsLabelled) {
    const Plot plot = plots_of(measured_sweep()).at(0).plot;
    int faint = 0;
    for (const PlotMark& mark : plot.series.at(0).marks) {
        if (mark.is_faint) ++faint;
        EXPECT_EQ(mark.label.empty(), mark.is_faint);
    }
    EXPECT_EQ(faint, 1);
    EXPECT_TRUE(plot.series.back().is_stepped);
}

TEST(Plot, IsDrawnByGnuplotAndNoTextBecomesMarkup) {
    Plot plot{
        "<script>alert(1)</script> \"quoted\" \\ {a}_b", "x", "y", true, false, {}, {{2.0, 0}}};
    plot.series = {
        {"one & two",
         {{1, 2, {}, Interval{1, 3}, "here", false}, {10, 3, {}, {}, "", true}},
         true,
         false},
        {.name = "front", .marks = {{.x = 1, .y = 2}, {.x = 10, .y = 1}}, .is_stepped = true}};
    const SilentProgress progress;
    const std::string svg = plot_svg(plot, progress);
    EXPECT_THAT(svg, HasSubstr("</svg>"));
    EXPECT_THAT(svg, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(svg, HasSubstr("here"));
    EXPECT_EQ(svg, plot_svg(plot, progress));
}

/// How far to the right of its picture a text stands.
double place_of(const std::string& text, const std::string& svg) {
    const std::string::size_type begin = svg.rfind("translate(", svg.find("> " + text + "</text>"));
    return std::stod(svg.substr(begin + std::string("translate(").size()));
}

TEST(Plot, AnAxisRunsFromTheFirstToTheLastOfItsTicks) {
    Plot plot{"t", "x", "y", true, false, {}, {}, {16, 7, 2}};
    plot.series = {
        {"a", {{16, 300, {}, {}, "", false}, {2, 300, {}, {}, "", false}}, false, false}};
    const SilentProgress progress;
    const std::string svg = plot_svg(plot, progress);
    EXPECT_THAT(svg, Not(HasSubstr("> 10</text>")));
    EXPECT_LT(place_of("16", svg), place_of("7", svg));
    EXPECT_LT(place_of("7", svg), place_of("2", svg));
}

TEST(Plot, WhatALogarithmDoesNotKnowIsLeftOutAndNothingIsAnError) {
    Plot plot{"t", "x", "y", true, false, {}, {}};
    plot.series = {{"a", {{0, 2, {}, {}, "", false}, {-1, 2, {}, {}, "", false}}, false, false}};
    const SilentProgress progress;
    try {
        static_cast<void>(plot_svg(plot, progress));
        FAIL() << "a plot of nothing was drawn";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-CHART-EMPTY");
    }
}

TEST(ChartFiles, AreAllThereAndThePageHoldsItsPictures) {
    const ScratchFolder scratch;
    const SilentProgress progress;
    write_chart_files(scratch.path(), measured_sweep(), progress);
    for (const char* name : {"chart.json", "chart.csv", "chart.html", "end-to-end.svg",
                             "drawing.svg", "size.svg", "stage-depth.svg"}) {
        EXPECT_TRUE(std::filesystem::exists(scratch / name)) << name;
    }
    const std::string page = read_whole_text(scratch / "chart.html");
    EXPECT_THAT(page, HasSubstr("demo &lt;b&gt;"));
    EXPECT_THAT(page, HasSubstr("data:image/svg+xml;base64,"));
    EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
    const std::string csv = read_whole_text(scratch / "chart.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
}

TEST(LabelChoice, TheLowestOfLabelsThatCoverEachOtherIsKept) {
    const std::vector<PlacedLabel> labels{{0.10, 0.52, "worse"},
                                          {0.12, 0.50, "better"},
                                          {0.60, 0.51, "to the right"},
                                          {0.10, 0.90, "above"}};
    EXPECT_EQ(readable_labels(labels), (std::vector<bool>{false, true, true, true}));
}

}  // namespace
}  // namespace lumi
