#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/image_io.h"
#include "calib/pictures/tiff_io.h"
#include "calib/poses/registration.h"
#include "calib/work/whole_file.h"
#include "tests/calib/cut_out_pictures.h"
#include "tests/pipeline/box_line.h"
#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::StartsWith;

class EvaluateCommand : public BoxLine {};

TEST_F(EvaluateCommand, EvaluatesHeldOutViews) {
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

TEST_F(EvaluateCommand, WhatSomebodyPutBesideItsPicturesOrIntoThePackageStays) {
    const std::string evaluate = "evaluate --no-ghost-energy " + quoted(workspace()) + " --mode ";
    configure("[evaluate]\nhold_out = [\"IMG_0005.png\"]\n");
    ASSERT_EQ(build(), "rrrrr");
    ASSERT_EQ(lumi(evaluate + "perpixel --mode lightfield").exit_code, 0);
    const fs::path strip = workspace() / "evaluation" / "IMG_0005.lightfield.png";
    EXPECT_TRUE(fs::exists(strip));
    for (const char* name : {"evaluation/notes.txt", "box.lumi/screenshot.png", "depth/Thumbs.db"})
        write_whole_text(workspace() / name, "the user's own");
    EXPECT_EQ(lumi(evaluate + "perpixel").exit_code, 0) << "nothing of it is stale";
    EXPECT_FALSE(fs::exists(strip)) << "of an evaluation before";
    configure("[evaluate]\nhold_out = [\"IMG_0004.png\"]\n");
    ASSERT_EQ(build(), "uurrr");
    ASSERT_EQ(build(), "uuuuu");
    ASSERT_EQ(lumi(evaluate + "perpixel").exit_code, 0);
    EXPECT_FALSE(fs::exists(workspace() / "evaluation" / "IMG_0005.png"));
    for (const char* name : {"evaluation/notes.txt", "box.lumi/screenshot.png", "depth/Thumbs.db"})
        EXPECT_EQ(read_whole_text(workspace() / name), "the user's own") << name;
    EXPECT_EQ(lumi("validate " + quoted(package())).exit_code, 0);
}

TEST_F(EvaluateCommand, ItsPicturesAreNoPhotographsWhereTheWorkspaceLiesAmongThese) {
    fs::copy(scene_->path() / "photos", workspace(), fs::copy_options::recursive);
    configure("[evaluate]\nhold_out = [\"IMG_0005.png\"]\n");
    std::string text = read_whole_text(config_path());
    const std::string elsewhere = (scene_->path() / "photos").string();
    text.replace(text.find(elsewhere), elsewhere.size(), workspace().string());
    write_whole_text(config_path(), text);
    ASSERT_EQ(build(), "rrrrr");
    ASSERT_EQ(lumi("evaluate --mode lightfield " + quoted(workspace())).exit_code, 0);
    EXPECT_EQ(build(), "uuuuu");
}

TEST_F(EvaluateCommand, EvaluateSaysWhatToSetWhenNothingIsHeldOut) {
    configure("");
    static_cast<void>(build());
    const Outcome outcome = lumi("evaluate " + quoted(workspace()));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.talk, HasSubstr("error E-EVAL-NOHOLDOUT"));
    EXPECT_THAT(outcome.talk, HasSubstr("hold_out_every = 8"));
}

TEST_F(EvaluateCommand, PhotographsWithoutAPoseAreCountedAndNamed) {
    Capture capture = read_colmap_model(scene_->path() / "truth" / "sparse");
    std::vector<char> is_dropped(capture.views.size(), 0);
    is_dropped.back() = 1;
    drop_views(capture, is_dropped);
    fs::create_directory(scratch_ / "sparse");
    write_colmap_model_text(capture, scratch_ / "sparse");
    write_whole_text(config_path(),
                     "name = \"box\"\n[capture]\nphotos = \"" +
                         (scene_->path() / "photos").string() +
                         "\"\nimport = \"sparse\"\n[evaluate]\nhold_out = [\"IMG_0005.png\", "
                         "\"IMG_0009.png\"]\n" +
                         kSparseDepth + kToldDrawing);
    static_cast<void>(build());
    const Outcome outcome =
        lumi("evaluate --mode lightfield --no-ghost-energy " + quoted(workspace()));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    EXPECT_THAT(outcome.out,
                HasSubstr("1 of 2 held-out photographs judged; IMG_0009.png has no pose\n"));
    const Json evaluation =
        Json::parse(read_whole_text(workspace() / "evaluation" / "evaluation.json"));
    EXPECT_EQ(evaluation.at("not_judged"), Json({"IMG_0009.png"}));
    EXPECT_THAT(read_whole_text(workspace() / "report.html"),
                HasSubstr("1 of 2 held-out photographs is reproduced at "));
}

TEST_F(EvaluateCommand, SaysOfWhichPhotographsItIs) {
    configure("max_width_px = 120\n[evaluate]\nhold_out = [\"IMG_0005.png\"]\n");
    const auto view_of_evaluation = [&] {
        static_cast<void>(build());
        const Outcome outcome =
            lumi("evaluate --json --mode lightfield --no-ghost-energy " + quoted(workspace()));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        return Json::parse(outcome.out).at("views").at(0);
    };
    const Json small = view_of_evaluation();
    fs::copy_file(workspace() / "evaluation" / "evaluation.json", scratch_ / "small.json");
    EXPECT_EQ(small.at("width_px"), 120);
    EXPECT_EQ(small.at("height_px"), 90);
    configure("[evaluate]\nhold_out = [\"IMG_0005.png\"]\n");
    const Json large = view_of_evaluation();
    EXPECT_EQ(large.at("width_px"), 160);
    EXPECT_NE(large.at("photograph_sha256"), small.at("photograph_sha256"));
    EXPECT_EQ(view_of_evaluation().at("photograph_sha256"), large.at("photograph_sha256"));
    const Outcome refused =
        lumi("compare-evaluations " + quoted(scratch_ / "small.json") + " " + quoted(workspace()));
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_THAT(refused.talk, HasSubstr("E-EVAL-DISJOINT: IMG_0005.png: 120 x 90 pixels in A"));
}

TEST_F(EvaluateCommand, TakesModesWithCommasBetween) {
    const Outcome refused = lumi("evaluate --mode adaptive,shiny " + quoted(workspace()));
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.talk, HasSubstr("there is no mode named shiny"));
}

TEST_F(EvaluateCommand, OptionsThatDoNotApplyAreRefused) {
    configure("");
    for (const char* options :
         {"--keep-depth ", "--leave-one-out --no-ghost-energy ", "--leave-one-out --rivals "})
        EXPECT_EQ(lumi("evaluate " + std::string(options) + quoted(config_path())).exit_code, 2)
            << options;
}

TEST_F(EvaluateCommand, OneMeshOfTheSceneDrawsNearlyAsWellAsTheDepthMapsItIsMadeFrom) {
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

TEST_F(EvaluateCommand, WhatAlphaCutsOutIsTheBackgroundUnlessItIsToBeKept) {
    constexpr int kHiddenRows = 22;  // Of the first, and two more of each after it.
    for (int i = 1; i <= 9; ++i) {
        const std::string name = "IMG_000" + std::to_string(i) + ".png";
        write_cut_out_png(scratch_ / "cut" / name,
                          read_color_image(scene_->path() / "photos" / name),
                          kHiddenRows + 2 * (i - 1));
    }
    for (const bool is_kept : {false, true}) {
        write_whole_text(config_path(), "name = \"box\"\n[capture]\nphotos = \"cut\"\nimport = \"" +
                                            (scene_->path() / "truth" / "sparse").string() +
                                            "\"\n" + kSparseDepth +
                                            (is_kept ? "background = \"keep\"\n" : "") +
                                            kToldDrawing);
        static_cast<void>(build());
        const FloatImage inverse_depth =
            read_float_tiff(workspace() / "depth" / "IMG_0001.inverse_depth.tif");
        for (int y = 0; y < 120; ++y)
            EXPECT_EQ(inverse_depth(80, y) == 0.0F, !is_kept && y < kHiddenRows) << y;
    }
}

TEST_F(EvaluateCommand, MasksAreUsedByDepthDrawingAndEvaluation) {
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

}  // namespace
}  // namespace lumi
