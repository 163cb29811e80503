#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/ingest/made_by_lumi.h"
#include "calib/work/whole_file.h"
#include "tests/pipeline/box_line.h"
#include "tests/pipeline/built_program.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;

class ViewCommands : public BoxLine {};

TEST_F(ViewCommands, PlansWhereToPhotographNext) {
    configure("");
    EXPECT_EQ(build("poses"), "rr");
    const Outcome outcome = lumi("plan --json --suggestions 2 " + quoted(workspace()));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json plan = Json::parse(outcome.out);
    ASSERT_EQ(plan.at("suggestions").size(), 2U);
    EXPECT_GT(plan.at("suggestions").at(0).at("predicted_error_px").get<double>(), 0.0);
    EXPECT_EQ(plan.at("suggestions").at(0).at("from").size(), 2U);
    EXPECT_THAT(read_whole_text(workspace() / "plan" / "plan.svg"), HasSubstr("</svg>"));
    EXPECT_THAT(lumi("plan --wish 0.01 " + quoted(workspace())).out,
                testing::AllOf(HasSubstr("0.01 px"), HasSubstr("by the poses alone")));
    EXPECT_THAT(lumi("plan --wish 1000 " + quoted(workspace())).out,
                HasSubstr("1000.00 px everywhere is reached already"));
}

TEST_F(ViewCommands, WorkspacesThatWereNotEvaluatedAreNotComparedAndSaidToBe) {
    configure("");
    EXPECT_EQ(build("ingest"), "r");
    const Outcome outcome =
        lumi("compare-evaluations " + quoted(workspace()) + " " + quoted(workspace()));
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.talk, testing::AllOf(HasSubstr("error E-EVAL-NONE"),
                                             HasSubstr("-> run `lumi evaluate ")));
}

TEST_F(ViewCommands, DrawsTheCurveOfViewsAgainstError) {
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
    const Outcome beyond = lumi("select --size 4 --size 8 " + quoted(workspace()));
    EXPECT_EQ(beyond.exit_code, 2);
    EXPECT_THAT(beyond.talk, HasSubstr("--size 8: the package has 7 views"));
    EXPECT_THAT(beyond.talk, testing::Not(HasSubstr("drawing")));
    EXPECT_THAT(lumi("select --least 9999 " + quoted(workspace())).talk,
                HasSubstr("--least 9999: the package has 7 views"));
    const fs::path charts = scratch_ / "charts";
    const Outcome table =
        lumi("select --size 4 --chart " + quoted(charts) + " " + quoted(workspace()));
    EXPECT_THAT(table.out, testing::StartsWith("     views   PSNR dB       MiB        ms\n"));
    EXPECT_THAT(table.talk, HasSubstr((charts / "loss.svg").string()));

    const Outcome held_out = lumi("view --view IMG_0005 --screenshot " +
                                  quoted(scratch_ / "shot.png") + " " + quoted(package()));
    EXPECT_EQ(held_out.exit_code, 2);
    EXPECT_THAT(held_out.talk, HasSubstr("'IMG_0005' was held out from this package"));
}

/// Sixteen views of the box so close together that not all are needed.
TEST_F(ViewCommands, AChartTellsMachinesHowTimeAndMemoryGrow) {
    configure("[growth]\nphotographs = [5, 8]\n");
    const Outcome outcome = lumi("chart --json --growth-alone " + quoted(config_path()) +
                                 " --out " + quoted(scratch_ / "chart"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    EXPECT_EQ(Json::parse(outcome.out).at("growth"),
              Json::parse(read_whole_text(scratch_ / "chart" / "growth.json")));
    EXPECT_TRUE(is_made_by_lumi(scratch_ / "chart"));
}

TEST_F(ViewCommands, AutoPacksAsManyViewsAsAreEnough) {
    SceneDescription scene = textured_box_description();
    scene.path.count = 16;
    scene.path.rows = 4;
    scene.path.length_share = 0.1;
    SilentProgress progress;
    synthesize_into(scratch_.path(), scene, 0, progress);
    write_whole_text(scratch_ / "box.toml",
                     "name = \"box\"\n[capture]\nphotos = \"photos\"\nimport = \"truth/sparse\"\n"
                     "[depth]\nimport_folder = \"truth/depth\"\n[evaluate]\nhold_out = "
                     "[\"IMG_0006.png\"]\n[package]\nviews = \"auto\"\n");
    const fs::path workspace = scratch_ / "work";
    const Outcome build =
        lumi("build " + quoted(scratch_ / "box.toml") + " --workspace " + quoted(workspace));
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
        lumi("bench-flicker --json --frames 6 --size 40x30 --out " + quoted(scratch_ / "flicker") +
             " " + quoted(workspace / "box.lumi"));
    ASSERT_EQ(flicker.exit_code, 0) << flicker.talk;
    const Json modes = Json::parse(flicker.out).at("modes");
    EXPECT_EQ(modes.size(), 5U);
    EXPECT_EQ(modes.at("perpixel").at("changes").size(), 5U);
    EXPECT_GT(modes.at("perpixel").at("mean_change").get<double>(), 0.0);
    EXPECT_THAT(read_whole_text(scratch_ / "flicker" / "flicker.svg"), HasSubstr("</svg>"));
    EXPECT_TRUE(fs::exists(scratch_ / "flicker" / "jump-perpixel.png"));
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

}  // namespace
}  // namespace lumi
