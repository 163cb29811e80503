#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/pipeline/built_program.h"
#include "tests/pipeline/told_choices.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;

/// The textured box with its true poses, and commands that build many packages of it.
class Sweeps : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        scene_ = new ScratchFolder();
        SilentProgress progress;
        synthesize_into(scene_->path(), textured_box_description(), 0, progress);
    }
    static void TearDownTestSuite() { delete scene_; }

    Outcome lumi(const std::string& arguments) const {
        return lumi::lumi(arguments, "cd " + quoted(scratch_.path()) + " &&");
    }
    /// A configuration with true poses, one photograph held out, and drawing that is told.
    void configure(const std::string& name, const std::string& more) const {
        write_whole_text(scratch_ / (name + ".toml"),
                         "[capture]\nphotos = \"" + (scene_->path() / "photos").string() +
                             "\"\nimport = \"" + (scene_->path() / "truth" / "sparse").string() +
                             "\"\n[evaluate]\nhold_out = [\"IMG_0005.png\"]\n" + kToldDrawing +
                             more);
    }
    /// Figures of pictures of every point, times aside.
    static std::map<std::string, Json> errors_of(const Json& chart) {
        std::map<std::string, Json> errors;
        for (const Json& variant : chart.at("variants")) {
            for (const auto& [mode, scores] : variant.at("modes").items()) {
                for (Json view : scores.at("views")) {
                    view.erase("ms");
                    view.erase("cpu_ms");
                    view.erase("ms_range");
                    errors[variant.at("label").get<std::string>() + mode +
                           view.at("name").get<std::string>()] = view;
                }
            }
        }
        return errors;
    }

    static ScratchFolder* scene_;
    ScratchFolder scratch_;
};

ScratchFolder* Sweeps::scene_ = nullptr;

constexpr const char* kSweep =
    "[sweep]\nrepeats = 2\nmodes = [\"perpixel\", \"lightfield\"]\n"
    "depth.model = [\"sparse\", \"sweep\"]\ndepth.max_width_px = [48, 80]\n";

TEST_F(Sweeps, AChartComputesNothingTwiceAndGivesTheSameErrorsAgain) {
    configure("box", kSweep);
    const Outcome first = lumi("--json chart box.toml");
    ASSERT_EQ(first.exit_code, 0) << first.talk;
    EXPECT_THAT(first.talk, HasSubstr("4 settings, each drawn in "));
    const Json chart = Json::parse(first.out);
    EXPECT_EQ(chart.at("variants").size(), 4U);
    EXPECT_GT(chart.at("work").at("cached_share").get<double>(), 0.2);
    for (const Json& variant : chart.at("variants")) {
        EXPECT_EQ(variant.at("failure"), "");
        EXPECT_TRUE(variant.at("repeats_are_equal").get<bool>());
        EXPECT_EQ(variant.at("stages").at("depth").at("cpu_s").size(), 2U);
    }
    EXPECT_TRUE(fs::exists(scratch_.path() / "work" / "box-chart" / "chart.html"));

    const Json again = Json::parse(lumi("--json chart box.toml").out);
    EXPECT_EQ(again.at("work").at("done_cpu_s"), 0.0);
    EXPECT_EQ(errors_of(again), errors_of(chart));
    const Json elsewhere = Json::parse(lumi("--json chart box.toml --out elsewhere").out);
    EXPECT_GT(elsewhere.at("work").at("done_cpu_s").get<double>(), 0.0);
    EXPECT_EQ(errors_of(elsewhere), errors_of(chart));
}

/// Copies of another size are no duplicates of their photographs.
TEST_F(Sweeps, AChartTakesNoneOfItsCopiesForAPhotographWhereItWorksAmongThem) {
    std::size_t photographs = 0;
    for (const auto& entry : fs::directory_iterator(scene_->path() / "photos")) {
        fs::copy_file(entry.path(), scratch_ / entry.path().filename());
        if (entry.path().extension() == ".png") ++photographs;
    }
    configure("box", std::string(kSparseDepth) +
                         "[sweep]\nmodes = [\"perpixel\"]\n"
                         "capture.max_width_px = [100, 120, 140]\n");
    std::string text = read_whole_text(scratch_ / "box.toml");
    const std::string elsewhere = (scene_->path() / "photos").string();
    text.replace(text.find(elsewhere), elsewhere.size(), ".");
    write_whole_text(scratch_ / "box.toml", text);
    const Outcome chart = lumi("--json chart box.toml");
    ASSERT_EQ(chart.exit_code, 0) << chart.talk;
    int variants = 0;
    for (const auto& entry : fs::directory_iterator(scratch_ / "work/box-chart/variants")) {
        const fs::path list = entry.path() / "ingest" / "photographs.json";
        EXPECT_EQ(Json::parse(read_whole_text(list)).at("photographs").size(), photographs);
        ++variants;
    }
    EXPECT_EQ(variants, 3);
}

TEST_F(Sweeps, AVariantThatCannotBeBuiltIsToldAndTheOthersGoOn) {
    configure("box", std::string(kSparseDepth) +
                         "[sweep]\nmodes = [\"perpixel\"]\ncapture.min_photographs = [2, 50]\n");
    const Outcome outcome = lumi("--json chart box.toml");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json chart = Json::parse(outcome.out);
    EXPECT_EQ(chart.at("variants").at(0).at("failure"), "");
    EXPECT_THAT(chart.at("variants").at(1).at("failure").get<std::string>(),
                testing::AllOf(HasSubstr("E-INGEST-TOOFEW"), HasSubstr(" -> ")));
}

TEST_F(Sweeps, WhereNoVariantCanBeBuiltABuildIsAdvised) {
    configure("box", std::string(kSparseDepth) +
                         "[sweep]\nmodes = [\"perpixel\"]\ncapture.min_photographs = [50, 60]\n");
    for (const char* command : {"chart box.toml", "build box.toml --target 1dB"}) {
        const Outcome outcome = lumi(command);
        EXPECT_THAT(outcome.talk, HasSubstr("error E-INGEST-TOOFEW")) << command;
        EXPECT_THAT(outcome.talk, HasSubstr("`lumi build` of the same configuration")) << command;
    }
}

TEST_F(Sweeps, ATargetIsMetByWhatIsDeliveredOrTheNearestIsTold) {
    configure("box",
              "[depth]\nmax_width_px = 80\n"
              "[sweep]\nmodes = [\"perpixel\"]\ndepth.model = [\"sparse\", \"sweep\"]\n");
    const Outcome met = lumi("--json build box.toml --target 15dB");
    ASSERT_EQ(met.exit_code, 0) << met.talk;
    const Json delivery = Json::parse(met.out);
    EXPECT_TRUE(delivery.at("is_met").get<bool>());
    EXPECT_GE(delivery.at("delivered").at("psnr_db").get<double>(), 15.0);
    EXPECT_THAT(met.talk, HasSubstr("1 dearer variants are not needed"));
    EXPECT_EQ(lumi("validate work/box/box.lumi").exit_code, 0);
    ASSERT_EQ(lumi("evaluate work/box --mode lightfield --no-ghost-energy").exit_code, 0);
    const auto report = [&] {
        return read_whole_text(scratch_.path() / "work" / "box" / "report.html");
    };
    EXPECT_THAT(report(), HasSubstr("15dB was wished for, and is met"));
    EXPECT_THAT(report(), HasSubstr("settings were chosen by these photographs"));

    const Outcome missed = lumi("--json build box.toml --target 90dB");
    EXPECT_EQ(missed.exit_code, 5);
    const Json nearest = Json::parse(missed.out);
    EXPECT_FALSE(nearest.at("is_met").get<bool>());
    EXPECT_EQ(nearest.at("error").at("code"), "E-TARGET-MISSED");
    EXPECT_THAT(missed.talk, HasSubstr("error E-TARGET-MISSED"));
    EXPECT_THAT(report(), HasSubstr("90dB was wished for, and is out of reach"));
    EXPECT_EQ(lumi("build box.toml --target fast").exit_code, 2);

    // What is built later as its configuration says was wished for by nobody.
    configure("box", kSparseDepth);
    ASSERT_EQ(lumi("build box.toml").exit_code, 0);
    EXPECT_THAT(report(), testing::Not(HasSubstr("was wished for")));
}

TEST_F(Sweeps, ADatasetBuildsWhatItCanAndOnlyWhatIsMissing) {
    configure("box", "");
    write_whole_text(scratch_.path() / "nothing" / "readme.txt", "no photograph");
    write_whole_text(scratch_ / "set.toml",
                     "[settings]\ndepth.model = \"sparse\"\n[[scene]]\nphotos = \"nothing\"\n"
                     "[[scene]]\nconfig = \"box.toml\"\n");
    const Outcome first = lumi("--json build set.toml");
    EXPECT_EQ(first.exit_code, 5);
    EXPECT_THAT(first.talk, HasSubstr("error E-DATASET-PARTIAL"));
    const Json told = Json::parse(first.out);
    EXPECT_EQ(told.at("scenes").size(), 2U);
    EXPECT_EQ(told.at("error").at("code"), "E-DATASET-PARTIAL");
    const Json result =
        Json::parse(read_whole_text(scratch_.path() / "work" / "set" / "dataset.json"));
    EXPECT_THAT(result.at("scenes").at(0).at("failure_code").get<std::string>(),
                HasSubstr("E-INGEST"));
    EXPECT_GT(result.at("scenes").at(1).at("mean").at("psnr_db").get<double>(), 10.0);

    const Outcome again = lumi("build set.toml");
    EXPECT_THAT(again.talk, HasSubstr("depth: up to date"));
    EXPECT_THAT(again.talk, testing::Not(HasSubstr("drawing held-out views")));
}

TEST_F(Sweeps, ADatasetTakesNoEvaluationThatWasMadeOtherwise) {
    configure("box", "");
    write_whole_text(scratch_ / "set.toml",
                     "[settings]\ndepth.model = \"sparse\"\n[[scene]]\nconfig = \"box.toml\"\n"
                     "name = \"statue\"\n");
    const fs::path workspace = scratch_.path() / "work" / "set" / "statue";
    const fs::path file = workspace / "evaluation" / "evaluation.json";
    const auto psnr_db = [&](bool is_evaluated) {
        const Outcome outcome = lumi("--json build set.toml");
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        EXPECT_EQ(outcome.talk.find("drawing held-out views") != std::string::npos, is_evaluated);
        return Json::parse(outcome.out).at("scenes").at(0).at("mean").at("psnr_db").get<double>();
    };
    const double expected = psnr_db(true);
    EXPECT_EQ(psnr_db(false), expected);
    for (const char* options : {" --mode lightfield", " --as-taken"}) {
        ASSERT_EQ(lumi("evaluate " + quoted(workspace) + options).exit_code, 0) << options;
        EXPECT_EQ(psnr_db(true), expected) << options;
    }
    ASSERT_EQ(lumi("evaluate " + quoted(workspace)).exit_code, 0);
    EXPECT_EQ(psnr_db(false), expected);

    Json of_other_code = Json::parse(read_whole_text(file));
    of_other_code["made_with"]["code"] = "other";
    Json without_views = Json::parse(read_whole_text(file));
    without_views["views"] = 3;
    for (const std::string& text :
         {of_other_code.dump(), without_views.dump(), read_whole_text(file).substr(0, 200)}) {
        write_whole_text(file, text);
        EXPECT_EQ(psnr_db(true), expected) << text.substr(0, 60);
    }
}

TEST_F(Sweeps, LeaveOneOutTakesNoneOfItsCopiesForAPhotographWhereItWorksAmongThem) {
    std::size_t photographs = 0;
    for (const auto& entry : fs::directory_iterator(scene_->path() / "photos")) {
        fs::copy_file(entry.path(), scratch_ / entry.path().filename());
        if (entry.path().extension() == ".png") ++photographs;
    }
    write_whole_text(scratch_ / "box.toml",
                     "[capture]\nphotos = \".\"\nmax_width_px = 100\nimport = \"" +
                         (scene_->path() / "truth" / "sparse").string() + "\"\n" + kSparseDepth +
                         kToldDrawing);
    for (int run = 0; run < 2; ++run) {
        const Outcome outcome =
            lumi("evaluate box.toml --leave-one-out --keep-depth --mode lightfield");
        ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
        const Json list = Json::parse(
            read_whole_text(scratch_ / "work/box-leave-one-out/whole/ingest/photographs.json"));
        EXPECT_EQ(list.at("photographs").size(), photographs);
        EXPECT_EQ(list.at("left_out").size(), 0U) << list.at("left_out");
    }
}

TEST_F(Sweeps, LeaveOneOutJudgesEveryPhotographWithAndWithoutItsDepth) {
    configure("box", kSparseDepth);
    const Outcome outcome = lumi("--json evaluate box.toml --leave-one-out --mode perpixel");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json result = Json::parse(outcome.out);
    EXPECT_EQ(result.at("depth_kept").at("views").size(), 9U);
    EXPECT_EQ(result.at("depth_removed").at("views").size(), 9U);
    EXPECT_EQ(result.at("depth_removed").at("views").at(4).at("name"), "IMG_0005.png");
    // The middle of the grid without its own photograph is what holding it out gives.
    ASSERT_EQ(lumi("build box.toml").exit_code, 0);
    const Json held_out = Json::parse(lumi("--json evaluate work/box --mode perpixel").out);
    EXPECT_EQ(result.at("depth_removed").at("views").at(4).at("psnr_db"),
              held_out.at("mean").at("psnr_db"));
}

TEST_F(Sweeps, LeaveOneOutBuildsTheCameraMeshesThatAreConfigured) {
    const auto middle_psnr_db = [&](const std::string& mesh) {
        configure("box", kSparseDepth + mesh);
        const Outcome outcome =
            lumi("--json evaluate box.toml --leave-one-out --keep-depth --mode perpixel");
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        return Json::parse(outcome.out).at("depth_kept").at("views").at(4).at("psnr_db");
    };
    EXPECT_NE(middle_psnr_db(""), middle_psnr_db("[mesh]\nconstruction = \"nearest\"\n"));
}

TEST_F(Sweeps, LeaveOneOutDrawsPhotographsAsTakenWhereThatIsAsked) {
    SceneDescription of_many_exposures = textured_box_description();
    of_many_exposures.sensor.exposure_drift_stops = 0.7;
    SilentProgress progress;
    synthesize_into(scratch_.path(), of_many_exposures, 0, progress);
    write_whole_text(scratch_ / "box.toml",
                     "[capture]\nphotos = \"photos\"\nimport = \"truth/sparse\"\n[depth]\n"
                     "import_folder = \"truth/depth\"\n" +
                         std::string(kToldDrawing));
    const auto middle_psnr_db = [&](const std::string& options) {
        const Outcome outcome =
            lumi("--json evaluate box.toml --leave-one-out --keep-depth --mode perpixel" + options);
        const Json result = Json::parse(outcome.out);
        EXPECT_EQ(result.at("exposures"), options.empty() ? "evened" : "as taken");
        return result.at("depth_kept").at("views").at(4).at("psnr_db").get<double>();
    };
    EXPECT_GT(std::abs(middle_psnr_db("") - middle_psnr_db(" --as-taken")), 0.1);
}

TEST_F(Sweeps, CornersThatTheLensDarkensAreEvenedOutAndJudgedAsItTakesThem) {
    constexpr double kFalloff = -1.5;
    SceneDescription darkened = textured_box_description();
    darkened.sensor.light_falloff = kFalloff;
    SilentProgress progress;
    synthesize_into(scratch_.path(), darkened, 0, progress);
    write_whole_text(scratch_ / "box.toml",
                     "[capture]\nphotos = \"photos\"\nimport = \"truth/sparse\"\n[depth]\n"
                     "import_folder = \"truth/depth\"\n[evaluate]\nhold_out_every = 4\n" +
                         std::string(kToldDrawing));
    ASSERT_EQ(lumi("build box.toml").exit_code, 0);
    const Json package = Json::parse(lumi("--json inspect work/box/box.lumi").out);
    EXPECT_NEAR(package.at("light_falloff").get<double>(), kFalloff, 0.1 * -kFalloff);
    const auto psnr_db = [&](const std::string& options) {
        const Json result = Json::parse(lumi("--json evaluate work/box" + options).out);
        return result.at("mean").at("psnr_covered_db").get<double>();
    };
    EXPECT_GT(psnr_db(""), psnr_db(" --as-taken") + 0.5);
}

TEST_F(Sweeps, ExactDepthIsStraightenedWhereNobodysFilesAre) {
    SceneDescription bent = textured_box_description();
    const Camera straight = bent.camera;
    bent.camera = {
        straight.width_px,
        straight.height_px,
        LensModel::kSimpleRadial,
        {focal_length_px(straight).x(), 0.5 * straight.width_px, 0.5 * straight.height_px, -0.1}};
    SilentProgress progress;
    synthesize_into(scratch_.path(), bent, 0, progress);
    write_whole_text(scratch_ / "box.toml",
                     "[capture]\nphotos = \"photos\"\nimport = \"truth/sparse\"\n[evaluate]\n"
                     "hold_out = [\"IMG_0005.png\"]\n" +
                         std::string(kSparseDepth) + kToldDrawing);
    ASSERT_EQ(lumi("build box.toml").exit_code, 0);
    const fs::path own = scratch_.path() / "rungs" / "box" / "truth" / "IMG_0001.png.tiff";
    write_whole_text(own, "the user's own");
    const Outcome outcome =
        lumi("--json bench-depth work/box --model sparse --truth truth/depth --out rungs");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    EXPECT_THAT(outcome.out, HasSubstr("right_share"));
    EXPECT_EQ(read_whole_text(own), "the user's own");
    EXPECT_EQ(std::distance(fs::directory_iterator(own.parent_path()), {}), 1);
    for (const auto& entry : fs::directory_iterator(scratch_.path() / "rungs"))
        EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << entry.path();
}

TEST_F(Sweeps, StressTakesAConfigurationAWorkspaceOrAPackage) {
    configure(
        "box",
        std::string(kSparseDepth) +
            "[stress]\nperturbations = [\"blur_px\"]\nblur_px = [2, 6]\nmodes = [\"perpixel\"]\n");
    const Outcome of_config = lumi("--json stress box.toml");
    ASSERT_EQ(of_config.exit_code, 0) << of_config.talk;
    const Json curve = Json::parse(of_config.out).at("curves").at(0);
    EXPECT_EQ(curve.at("strengths"), Json({0.0, 2.0, 6.0}));
    EXPECT_GT(curve.at("psnr_db").at(0).get<double>(), curve.at("psnr_db").at(2).get<double>());
    EXPECT_TRUE(fs::exists(scratch_.path() / "work" / "box" / "stress" / "stress.html"));

    const Outcome of_package = lumi("--json stress work/box/box.lumi");
    ASSERT_EQ(of_package.exit_code, 0) << of_package.talk;
    EXPECT_FALSE(Json::parse(of_package.out).at("views_are_held_out").get<bool>());
}

TEST_F(Sweeps, RegressionAndGalleryTakeAnEvaluatedWorkspace) {
    configure("box", kSparseDepth);
    ASSERT_EQ(lumi("build box.toml").exit_code, 0);
    EXPECT_EQ(lumi("gallery work/box --out pictures").exit_code, 2);
    ASSERT_EQ(lumi("evaluate work/box --no-ghost-energy").exit_code, 0);
    write_whole_text(scratch_ / "pictures/gallery.md", "# Gallery: another package\n");
    write_whole_text(scratch_ / "pictures/stress-poses.svg", "of another package");
    const Outcome gallery = lumi("--json gallery work/box --out pictures");
    EXPECT_EQ(gallery.exit_code, 0) << gallery.talk;
    EXPECT_EQ(Json::parse(gallery.out).at("page"), "pictures/gallery.md");
    for (const char* name : {"held-out.jpg", "methods.jpg", "gallery.md"}) {
        EXPECT_TRUE(fs::exists(scratch_.path() / "pictures" / name)) << name;
    }
    EXPECT_FALSE(fs::exists(scratch_.path() / "pictures" / "stress-poses.svg"));
    const std::string small = " --frames 2 --rounds 1";
    ASSERT_EQ(lumi("regression work/box --write base.json" + small).exit_code, 0);
    Json base = Json::parse(read_whole_text(scratch_ / "base.json"));
    // Two frames on a busy machine may take any time: noise that no time can leave. Errors keep
    // theirs.
    for (const auto& [name, figure] : base.at("figures").items()) {
        if (!name.starts_with("error.")) {
            figure["noise"] = 1000 * std::abs(figure["value"].get<double>());
        }
    }
    write_whole_text(scratch_ / "base.json", base.dump());
    EXPECT_EQ(lumi("regression work/box --baseline base.json" + small).exit_code, 0);
    EXPECT_THAT(lumi("regression work/box --baseline base.json").talk,
                HasSubstr("E-REGRESSION-OTHER"));
    base["figures"]["error.perpixel.psnr_db"] = {
        {"value", 99.0}, {"noise", 0.01}, {"higher_is_better", true}};
    write_whole_text(scratch_ / "base.json", base.dump());
    const Outcome worse = lumi("regression work/box --baseline base.json" + small);
    EXPECT_EQ(worse.exit_code, 5);
    EXPECT_THAT(worse.out, HasSubstr("error.perpixel.psnr_db"));

    base["figures"] = {
        {"error.gone.flip", {{"value", 0.1}, {"noise", 0.01}, {"higher_is_better", false}}}};
    write_whole_text(scratch_ / "base.json", base.dump());
    const Outcome missing = lumi("--json regression work/box --baseline base.json" + small);
    EXPECT_EQ(missing.exit_code, 5);
    const Json compared = Json::parse(missing.out);
    EXPECT_EQ(compared.at("compared"), 0);
    EXPECT_EQ(compared.at("only_in_baseline"), Json::array({"error.gone.flip"}));
    EXPECT_EQ(compared.at("error").at("code"), "E-REGRESSION-MISSING");
}

}  // namespace
}  // namespace lumi
