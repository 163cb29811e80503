#include "pipeline/evaluate/evaluation_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/workspace/json_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

/// A workspace with a package and an evaluation, as far as telling which is of which goes.
class CurrentEvaluation : public testing::Test {
 protected:
    CurrentEvaluation() {
        write_whole_text(layout_.package_folder() / "lumigraph.json", "{}");
        made_from("pictures", "depth");
    }

    void made_from(const std::string& pictures, const std::string& depth) const {
        write_whole_text(layout_.stage_folder("pack") / "pack.json",
                         Json{{"held_out", Json::array()},
                              {"pictures_sha256", pictures},
                              {"package_sha256", ""},
                              {"depth_sha256", depth}}
                             .dump());
    }

    [[nodiscard]] Json evaluation() const {
        return {{"schema_version", kEvaluationSchemaVersion},
                {"package_sha256", package_sha256(layout_)},
                {"pictures_sha256", "pictures"},
                {"depth_sha256", "depth"}};
    }
    void write_configuration() const {
        write_whole_text(layout_.config_path(),
                         std::string(kWorkspaceConfigHeader) + "\nname = \"box\"\n");
    }
    [[nodiscard]] Json read_back(const std::string& text) const {
        write_whole_text(layout_.evaluation_folder() / "evaluation.json", text);
        return read_current_evaluation(layout_);
    }

    ScratchFolder scratch_;
    WorkspaceLayout layout_{scratch_ / "work", "box"};
};

TEST_F(CurrentEvaluation, IsThatOfThePackage) {
    EXPECT_TRUE(read_current_evaluation(layout_).is_null());
    EXPECT_EQ(read_back(evaluation().dump()), evaluation());
    const std::string former = evaluation().dump();
    write_whole_text(layout_.package_folder() / "lumigraph.json", "{\"other\": 1}");
    EXPECT_TRUE(read_back(former).is_null());
}

TEST_F(CurrentEvaluation, IsOfThePhotographsThatItWasComparedWith) {
    EXPECT_FALSE(read_back(evaluation().dump()).is_null());
    made_from("other pictures", "depth");
    EXPECT_TRUE(read_current_evaluation(layout_).is_null());
    made_from("pictures", "other depth");
    EXPECT_TRUE(read_current_evaluation(layout_).is_null());
}

TEST_F(CurrentEvaluation, IsNoneWhenItsFileIsDamaged) {
    const std::string whole = evaluation().dump();
    Json no_number = evaluation();
    no_number["schema_version"] = "three";
    for (const std::string& damaged :
         {std::string(), std::string("[]"), std::string("3"), std::string("{}"),
          whole.substr(0, whole.size() / 2), no_number.dump()}) {
        EXPECT_TRUE(read_back(damaged).is_null()) << damaged;
    }
}

TEST_F(CurrentEvaluation, IsNoneWhereTheRecordOfThePackageIsDamaged) {
    static_cast<void>(read_back(evaluation().dump()));
    write_whole_text(layout_.stage_folder("pack") / "pack.json", "{");
    EXPECT_TRUE(read_current_evaluation(layout_).is_null());
}

TEST_F(CurrentEvaluation, OneOfAVersionThatDoesNotSayOfWhichPhotographsIsNotCalledThatOfAnother) {
    write_configuration();
    Json before = evaluation();
    before.erase("pictures_sha256");
    EXPECT_TRUE(read_back(before.dump()).is_null());
    try {
        static_cast<void>(read_evaluation(layout_.folder()));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-EVAL-STALE");
        EXPECT_NE(std::string(error.what()).find("a version before"), std::string::npos);
    }
}

TEST_F(CurrentEvaluation, OneThatIsNamedIsRefusedWhenItIsDamaged) {
    const auto path = scratch_ / "evaluation.json";
    for (const char* damaged : {"[]", "{\"schema_version\": \"three\"}"}) {
        write_whole_text(path, damaged);
        try {
            static_cast<void>(read_evaluation(path));
            FAIL() << damaged;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-EVAL-SCHEMA") << damaged;
        }
    }
}

TEST_F(CurrentEvaluation, OneThatIsNamedByItsWorkspaceIsOfThePackageThatStandsThere) {
    write_configuration();
    static_cast<void>(read_back(evaluation().dump()));
    EXPECT_EQ(read_evaluation(layout_.folder()), evaluation());
    write_whole_text(layout_.package_folder() / "lumigraph.json", "{\"other\": 1}");
    try {
        static_cast<void>(read_evaluation(layout_.folder()));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-EVAL-STALE");
        EXPECT_NE(error.advice().find("lumi evaluate"), std::string::npos);
    }
    // The file alone may be kept to compare with what comes after it.
    EXPECT_NO_THROW(
        static_cast<void>(read_evaluation(layout_.evaluation_folder() / "evaluation.json")));
}

TEST(Scores, AreReadBackAsTheyWereWritten) {
    ViewScore score{.name = "IMG_1.jpg", .psnr_db = 31.5, .ssim = 0.9, .coverage = 0.75, .ms = 4};
    score.cpu_ms = 7;
    score.flip = 0.125;
    score.gain = {1.25, 1.0, 0.5};
    score.place = ViewPlace::kBorder;
    score.fastest_ms = 3;
    score.slowest_ms = 5;
    ViewScore whole = score;
    whole.psnr_covered_db = 32.25;
    whole.flip_covered = 0.0625;
    whole.edge_sharpness = 0.8;
    whole.psnr_gain_fitted_db = 33.5;
    whole.ghost_energy = 2.5;
    whole.psnr_subject_db = 30.5;
    whole.flip_subject = 0.25;
    whole.subject_coverage = 0.5;
    whole.subject_share = 0.1;
    whole.width_px = 768;
    whole.height_px = 512;
    whole.photograph_sha256 = "a";
    const ModeScores scores{RenderMode::kPerPixel, {score, whole}, 0.5, {}};
    const ModeScores again = mode_scores_from(scores.mode, mode_scores_json(scores));
    EXPECT_EQ(again.views, scores.views);
    EXPECT_EQ(again.ghost_between_blocks, scores.ghost_between_blocks);
    EXPECT_EQ(again.ghost_between_views, scores.ghost_between_views);
}

TEST(EvaluationMadeWith, TellsEverythingThatDecidesFiguresApart) {
    EvaluationOptions one_mode;
    one_mode.modes = {RenderMode::kLightField};
    EvaluationOptions as_taken;
    as_taken.exposures = Exposures::kAsTaken;
    EvaluationOptions without_ghosts;
    without_ghosts.ghost_energy = false;
    EvaluationOptions with_rivals;
    with_rivals.rivals = true;
    const std::set<std::string> different{made_with_json({}, "code").dump(),
                                          made_with_json({}, "other code").dump(),
                                          made_with_json(one_mode, "code").dump(),
                                          made_with_json(as_taken, "code").dump(),
                                          made_with_json(without_ghosts, "code").dump(),
                                          made_with_json(with_rivals, "code").dump()};
    EXPECT_EQ(different.size(), 6U);
}

TEST(EvaluationMadeWith, ConformsToTheSchema) {
    const Json schema =
        read_json_file(std::string(LUMI_SOURCE_DIR) + "/pipeline/evaluate/evaluation.schema.json")
            .at("properties")
            .at("made_with");
    const Json made_with = made_with_json({}, "code");
    EXPECT_EQ(made_with.size(), schema.at("properties").size());
    for (const Json& key : schema.at("required")) {
        EXPECT_TRUE(made_with.contains(key.get<std::string>())) << key;
        EXPECT_TRUE(schema.at("properties").contains(key.get<std::string>())) << key;
    }
}

}  // namespace
}  // namespace lumi
