#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <new>
#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/evaluate/comparison_strip.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/evaluate/metric_words.h"
#include "pipeline/report/sections.h"
#include "pipeline/report/spread.h"
#include "pipeline/report/verdict.h"
#include "pipeline/report/workspace_report.h"
#include "pipeline/stages/color_scale.h"
#include "pipeline/stages/drawing_effort.h"
#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

std::string base64_of(const std::string& text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(Html, Base64MeetsTheVectorsOfRfc4648) {
    EXPECT_EQ(base64_of(""), "");
    EXPECT_EQ(base64_of("f"), "Zg==");
    EXPECT_EQ(base64_of("fo"), "Zm8=");
    EXPECT_EQ(base64_of("foo"), "Zm9v");
    EXPECT_EQ(base64_of("foob"), "Zm9vYg==");
    EXPECT_EQ(base64_of("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
}

TEST(Html, NoTextBecomesMarkup) {
    const std::string hostile = R"(<script>alert("x")</script> & 'y')";
    const std::string escaped =
        "&lt;script&gt;alert(&quot;x&quot;)&lt;/script&gt; &amp; &#39;y&#39;";
    EXPECT_EQ(html_escaped(hostile), escaped);
    for (const std::string& html :
         {html_table({hostile}, {{hostile}}), html_section(hostile, ""), html_details(hostile, ""),
          html_figure(ColorImage(4, 4), 4, hostile), html_page(hostile, "")}) {
        EXPECT_EQ(html.find("<script"), std::string::npos);
        EXPECT_NE(html.find("&lt;script"), std::string::npos);
    }
}

TEST(DrawingEffort, OnePhotographIsCountedInTheSingular) {
    OcclusionEffort effort;
    effort.pictures = 1;
    EXPECT_THAT(text_of(effort), testing::HasSubstr(" px: 1 photograph is drawn "));
    effort.pictures = 2;
    EXPECT_THAT(text_of(effort), testing::HasSubstr(" px: 2 photographs are drawn "));
}

TEST(DrawingEffort, ALossIsNotCalledBetter) {
    OcclusionEffort effort;
    effort.pictures = 2;
    effort.standard_error_db = 0.06;
    effort.gains_db = -0.05;
    EXPECT_THAT(text_of(effort), testing::HasSubstr(" drawn 0.05 +- 0.06 dB worse than with "));
    for (const double gain_db : {0.05, 0.0, -0.001}) {
        effort.gains_db = gain_db;
        EXPECT_THAT(text_of(effort), testing::HasSubstr(" +- 0.06 dB better than with "));
        EXPECT_THAT(text_of(effort), testing::Not(testing::HasSubstr("-0.0")));
    }
}

TEST(Report, OfADamagedWorkspaceIsRefusedInWords) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "stages.json", R"({"stages": [{"name": "ingest"}]})");
    try {
        write_workspace_report(WorkspaceLayout(scratch.path(), "x"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-JSON-READ");
        EXPECT_THAT(error.what(), testing::StartsWith(scratch.path().string() + ": stages.json"));
        EXPECT_THAT(error.what(), testing::EndsWith("key 'evidence' not found"));
    }
}

TEST(Report, IsWrittenWhateverEndsTheWorkButAnInterruption) {
    const ScratchFolder scratch;
    const WorkspaceLayout workspace(scratch.path(), "x");
    write_json_file(workspace.stages_path(), Json{{"schema_version", 1},
                                                  {"stages", Json::array()},
                                                  {"failure",
                                                   {{"stage", "ingest"},
                                                    {"code", "E-TEST"},
                                                    {"what", "ends"},
                                                    {"advice", ""},
                                                    {"exit_code", 3}}}});
    write_whole_text(workspace.config_path(), kWorkspaceConfigHeader);
    const auto is_told_of = [&](const std::function<void()>& end) {
        write_whole_text(workspace.report_path(), "of a run before");
        EXPECT_ANY_THROW(work_and_report(workspace, end));
        return read_whole_text(workspace.report_path()) != "of a run before";
    };
    EXPECT_TRUE(is_told_of([] { throw Error(ErrorKind::kBadInput, "E-TEST", "", ""); }));
    EXPECT_TRUE(is_told_of([] { throw std::bad_alloc(); }));
    EXPECT_FALSE(is_told_of([] { throw Error(ErrorKind::kInterrupted, "E-TEST", "", ""); }));
}

TEST(NumberText, HasFixedDecimals) {
    EXPECT_EQ(number_text(1.005, 1), "1.0");
    EXPECT_EQ(number_text(-2.75, 1), "-2.8");
    EXPECT_EQ(number_text(31.4159, 0), "31");
    EXPECT_EQ(shortest_number_text(0.1), "0.1");
    EXPECT_EQ(shortest_number_text(100), "100");
}

Evaluation two_modes() {
    Evaluation evaluation;
    evaluation.gl_description = "GL";
    const ViewScore a{.name = "a.jpg",
                      .psnr_db = 30.0,
                      .psnr_covered_db = 31.0,
                      .ssim = 0.9,
                      .coverage = 1.0,
                      .ms = 4.0};
    const ViewScore b{.name = "b.jpg", .psnr_db = 20.0, .ssim = 0.7, .coverage = 0.0, .ms = 8.0};
    const ViewScore c{.name = "a.jpg",
                      .psnr_db = 10.0,
                      .psnr_covered_db = 12.0,
                      .ssim = 0.5,
                      .coverage = 0.5,
                      .ms = 2.0};
    evaluation.modes = {{RenderMode::kPerPixel, {a, b}, {}, {}},
                        {RenderMode::kLightField, {c}, {}, {}}};
    return evaluation;
}

TEST(EvaluationFile, SaysWhatOtherToolsRelyOn) {
    const Json json = evaluation_json(two_modes());
    EXPECT_EQ(json.at("mode"), "perpixel");
    EXPECT_DOUBLE_EQ(json.at("mean").at("psnr_db"), 25.0);
    EXPECT_DOUBLE_EQ(json.at("mean").at("psnr_covered_db"), 31.0);
    EXPECT_DOUBLE_EQ(json.at("mean").at("ssim"), 0.8);
    EXPECT_DOUBLE_EQ(json.at("mean").at("coverage"), 0.5);
    EXPECT_DOUBLE_EQ(json.at("mean").at("ms"), 6.0);
    EXPECT_EQ(json.at("views").at(0).at("name"), "a.jpg");
    EXPECT_TRUE(json.at("views").at(1).at("psnr_covered_db").is_null());
    EXPECT_DOUBLE_EQ(json.at("modes").at("lightfield").at("mean").at("psnr_db"), 10.0);
}

TEST(ComparisonStrip, ShowsPhotographRenderingAndError) {
    const ColorImage photograph(20, 60, {100, 100, 100});
    ColorImage rendering = photograph;
    rendering(3, 4) = {164, 100, 100};
    const ColorImage strip = comparison_strip(photograph, rendering, GrayImage(20, 60, 255), 64);
    EXPECT_EQ(strip(3, 4), (Rgb8{100, 100, 100}));
    EXPECT_EQ(strip(24 + 3, 4), (Rgb8{164, 100, 100}));
    EXPECT_EQ(strip(48 + 3, 4), color_of_share(1.0F));
    EXPECT_EQ(strip(48 + 4, 4), color_of_share(0.0F));
}

TEST(ComparisonStrip, ComesApartAgain) {
    for (const int height : {20, 60, 333, 768}) {
        ColorImage photograph(31, height, {10, 20, 30});
        ColorImage rendering(31, height, {40, 50, 60});
        photograph(30, height - 1) = {1, 2, 3};
        rendering(0, 0) = {4, 5, 6};
        const ComparisonPanels panels =
            panels_of(comparison_strip(photograph, rendering, GrayImage(31, height, 255)));
        EXPECT_EQ(panels.photograph, photograph) << height;
        EXPECT_EQ(panels.rendering, rendering) << height;
        EXPECT_EQ(panels.error.height(), height);
    }
    EXPECT_THROW(static_cast<void>(panels_of(ColorImage(10, 10))), Error);
}

TEST(Spread, TakesTheFirstAndNoMoreThanThereAre) {
    EXPECT_EQ(spread(3, 5), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(spread(10, 3), (std::vector<std::size_t>{0, 3, 6}));
    EXPECT_TRUE(spread(0, 3).empty());
}

TEST(ColorScale, GrowsLighterAllTheWay) {
    double before = -1.0;
    for (int i = 0; i <= 100; ++i) {
        const Rgb8 color = color_of_share(static_cast<float>(i) / 100.0F);
        const double lightness = 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
        EXPECT_GE(lightness, before) << i;
        before = lightness;
    }
    EXPECT_EQ(color_of_share(-5.0F), color_of_share(0.0F));
    EXPECT_EQ(color_of_share(5.0F), color_of_share(1.0F));
}

Json stages_of_a_good_run() {
    return Json::parse(R"({"stages": [
        {"name": "ingest", "evidence": {"photographs": 9, "left_out": []}},
        {"name": "poses", "evidence": {"photographs_total": 9, "not_registered": [],
                                       "warnings": []}},
        {"name": "pack", "evidence": {}}]})");
}

const StandingPackage kMade{true, {}};

TEST(Verdict, IsGoodWhenNothingIsMissing) {
    EXPECT_EQ(verdict_of(stages_of_a_good_run(), kMade, nullptr).level, Verdict::Level::kGood);
}

TEST(Verdict, IsFairWhenAPhotographFoundNoPlace) {
    Json stages = stages_of_a_good_run();
    stages["stages"][1]["evidence"]["not_registered"] = {
        {{"name", "a"}, {"code", "E"}, {"reason", "r"}}};
    EXPECT_EQ(verdict_of(stages, kMade, nullptr).level, Verdict::Level::kFair);
}

TEST(Verdict, PassesWarningsOfThePosesOn) {
    Json stages = stages_of_a_good_run();
    stages["stages"][1]["evidence"]["warnings"] = {"the scene looks flat"};
    const Verdict verdict = verdict_of(stages, kMade, nullptr);
    EXPECT_EQ(verdict.level, Verdict::Level::kFair);
    EXPECT_EQ(verdict.remarks.at(0), "the scene looks flat");
}

TEST(Verdict, IsBadWhenTheLineEndedEarlyAndSaysWhy) {
    Json stages = stages_of_a_good_run();
    stages["failure"] = {{"code", "E-POSES-FEW"}, {"what", "3 of 9"}, {"advice", "go slower"}};
    const Verdict verdict = verdict_of(stages, kMade, nullptr);
    EXPECT_EQ(verdict.level, Verdict::Level::kBad);
    EXPECT_NE(verdict.headline.find("E-POSES-FEW"), std::string::npos);
    EXPECT_EQ(verdict.remarks.at(0), "go slower");
}

TEST(Verdict, SaysThatAPackageOfAnEarlierRunStandsThere) {
    const StandingPackage former{true, "the package is of an earlier configuration"};
    Json stages = stages_of_a_good_run();
    stages["failure"] = {{"code", "E-POSES-FEW"}, {"what", "3 of 9"}, {"advice", "go slower"}};
    EXPECT_NE(verdict_of(stages, former, nullptr).remarks.at(1).find("earlier configuration"),
              std::string::npos);
    stages.erase("failure");
    stages["stages"].erase(2);
    const Verdict verdict = verdict_of(stages, former, nullptr);
    EXPECT_EQ(verdict.level, Verdict::Level::kFair);
    EXPECT_EQ(verdict.headline, "The line was not run to its end.");
    EXPECT_NE(verdict.remarks.at(0).find("earlier configuration"), std::string::npos);
    EXPECT_EQ(verdict_of(stages, {}, nullptr).headline,
              "The line was not run to its end: there is no package yet.");
    EXPECT_EQ(verdict_of(stages, kMade, nullptr).headline,
              "The package is finished, by a run before the last one.");
}

TEST(Verdict, CountsThePhotographsThatWereJudged) {
    Json evaluation{{"mean", {{"psnr_db", 30.0}, {"coverage", 1.0}}},
                    {"views", Json::array({"a"})},
                    {"not_judged", Json::array()}};
    const auto headline = [&] {
        return verdict_of(stages_of_a_good_run(), kMade, evaluation).headline;
    };
    EXPECT_NE(headline().find("Held-out photographs are reproduced at 30.0 dB"), std::string::npos);
    evaluation["not_judged"] = {"b"};
    EXPECT_NE(headline().find("1 of 2 held-out photographs is reproduced at 30.0 dB"),
              std::string::npos);
    evaluation.erase("not_judged");  // As in files of early versions.
    EXPECT_NE(headline().find("Held-out photographs are"), std::string::npos);
}

TEST(Verdict, SaysWhereExposureAloneMakesPicturesDiffer) {
    Json evaluation{{"mean",
                     {{"psnr_db", 23.1},
                      {"coverage", 1.0},
                      {"psnr_covered_db", 23.5},
                      {"psnr_gain_fitted_db", 24.4}}},
                    {"views", Json::array({"a"})}};
    const auto headline = [&] {
        return verdict_of(stages_of_a_good_run(), kMade, evaluation).headline;
    };
    EXPECT_EQ(headline().find("exposure"), std::string::npos) << "within a decibel";
    evaluation["mean"]["psnr_gain_fitted_db"] = 31.8;
    EXPECT_NE(headline().find("in exposure: but for that it would be 31.8 dB over what is covered"),
              std::string::npos);
}

TEST(Report, SaysWhereSettingsWereChosenByTheHeldOutPhotographs) {
    const ScratchFolder scratch;
    ReportSources sources{WorkspaceLayout(scratch.path(), "box"),
                          stages_of_a_good_run(),
                          kMade,
                          {{"views", Json::array()}},
                          nullptr};
    EXPECT_EQ(target_section(sources), "");
    EXPECT_NE(pictures_section(sources).find("in nothing else"), std::string::npos);
    const Json measured{
        {"psnr_db", 21.5}, {"frames_per_second", 9.0}, {"package_mib", 1.0}, {"build_s", 2.0}};
    sources.target = {
        {"wish", "20dB"},     {"is_met", true},       {"settings", {"depth.model = <b>"}},
        {"mode", "perpixel"}, {"promised", measured}, {"delivered", measured}};
    EXPECT_EQ(pictures_section(sources).find("in nothing else"), std::string::npos);
    EXPECT_NE(pictures_section(sources).find("settings were chosen by these photographs"),
              std::string::npos);
    const std::string html = target_section(sources);
    for (const char* told : {"20dB was wished for, and is met", "perpixel",
                             "depth.model = &lt;b&gt;", "21.5", "promised", "measured"})
        EXPECT_NE(html.find(told), std::string::npos) << told;
}

/// The section of figures of an evaluation with one mean and this correlation.
std::string figures_with(double ghost_correlation) {
    Json mean;
    for (const MetricWords& words : metric_words()) mean[words.name] = nullptr;
    const Json nothing{{"views", 0}};
    ReportSources sources{WorkspaceLayout("work", "cat"), {}, {}, {}, {}};
    sources.evaluation = Json{{"subject_from", nullptr},
                              {"mode", "perpixel"},
                              {"mean", mean},
                              {"views", Json::array()},
                              {"interior", nothing},
                              {"border", nothing},
                              {"modes", Json::object()},
                              {"rivals", nullptr},
                              {"ghost_rank_correlation", {{"between_blocks", ghost_correlation}}},
                              {"gl", "plain"}};
    return figures_section(sources);
}

TEST(FiguresSection, DoesNotSayThatGhostEnergyTellsErrorsWhereItDoesNot) {
    using testing::HasSubstr;
    EXPECT_THAT(figures_with(0.64),
                HasSubstr("the blended cameras disagree, the picture is wrong"));
    EXPECT_THAT(figures_with(0.15), HasSubstr("disagree hardly tells where the picture is wrong"));
    for (const double rank : {0.05, -0.34})
        EXPECT_THAT(figures_with(rank),
                    HasSubstr("says nothing here of where the picture is wrong"));
    EXPECT_THAT(figures_with(-0.34), HasSubstr("is -0.34 over blocks"));
}

TEST(FiguresSection, SaysWhatEachOfItsFiguresMeans) {
    const std::string html = figures_with(0.5);
    for (const char* name : {"psnr_db", "flip", "edge_sharpness", "psnr_gain_fitted_db"}) {
        const auto has_name = [&](const ScoreMetric& metric) {
            return metric.name == std::string(name);
        };
        const auto metric = std::find_if(score_metrics().begin(), score_metrics().end(), has_name);
        EXPECT_THAT(html, testing::HasSubstr(html_escaped(words_of(*metric).meaning))) << name;
    }
}

TEST(MetricWords, AreThereForEveryFigureAndTellItsRange) {
    ASSERT_EQ(metric_words().size(), score_metrics().size());
    for (std::size_t i = 0; i < score_metrics().size(); ++i)
        EXPECT_STREQ(metric_words()[i].name, score_metrics()[i].name);
    EXPECT_EQ(told_range(score_metrics()[0], {22.6277, 28.4296}), "PSNR 22.63 to 28.43 dB");
    const auto is_coverage = [](const ScoreMetric& metric) {
        return metric.name == std::string("coverage");
    };
    const auto coverage = std::find_if(score_metrics().begin(), score_metrics().end(), is_coverage);
    EXPECT_EQ(told_range(*coverage, {0.9, 0.98765}), "coverage 90.00 to 98.77 %");
}

}  // namespace
}  // namespace lumi
