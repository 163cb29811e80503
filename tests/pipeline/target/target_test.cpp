#include <gtest/gtest.h>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "pipeline/target/candidates.h"
#include "pipeline/target/wish.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

TEST(Wish, IsANumberAndAUnit) {
    EXPECT_EQ(wish_from("30fps").kind, Wish::Kind::kFramesPerSecond);
    EXPECT_EQ(wish_from("29.5dB").value, 29.5);
    EXPECT_EQ(wish_from("50 MiB").kind, Wish::Kind::kPackageMib);
    EXPECT_EQ(wish_from("1.5min").value, 90.0);
    EXPECT_EQ(wish_from("90s").kind, Wish::Kind::kBuildSeconds);
    for (const char* wrong : {"", "30", "fps", "-3dB", "0fps", "3db", "3 fps x", "nandB", "infs"}) {
        EXPECT_THROW(static_cast<void>(wish_from(wrong)), Error) << wrong;
    }
}

TEST(Wish, IsMetFromTheRightSide) {
    const Achievement achievement{
        .frames_per_second = 20, .psnr_db = 25, .package_mib = 40, .build_s = 100};
    EXPECT_TRUE(meets(wish_from("20fps"), achievement));
    EXPECT_FALSE(meets(wish_from("21fps"), achievement));
    EXPECT_FALSE(meets(wish_from("26dB"), achievement));
    EXPECT_TRUE(meets(wish_from("40MiB"), achievement));
    EXPECT_FALSE(meets(wish_from("39MiB"), achievement));
    EXPECT_TRUE(meets(wish_from("2min"), achievement));
    EXPECT_FALSE(meets(wish_from("1min"), achievement));
    EXPECT_NEAR(shortfall(wish_from("50dB"), achievement), 0.5, 1e-12);
    EXPECT_EQ(shortfall(wish_from("20dB"), achievement), 0.0);
}

ChartPoint point(const std::string& label, double cpu_s, double ms, double flip, double psnr_db) {
    ChartPoint made;
    made.label = label;
    made.build_cpu_s = cpu_s;
    made.build_wall_s = cpu_s;
    made.frame_ms = ms;
    made.mean.flip = flip;
    made.mean.psnr_db = psnr_db;
    return made;
}

const std::vector<ChartPoint> kPoints{point("quick", 5, 10, 0.3, 20),
                                      point("middle", 20, 25, 0.2, 25),
                                      point("good", 60, 50, 0.1, 30)};

TEST(Candidates, AnAccuracyIsReachedByTheQuickestThatHasIt) {
    EXPECT_EQ(candidates_for(wish_from("24dB"), kPoints)[0].label, "middle");
    EXPECT_EQ(candidates_for(wish_from("24dB"), kPoints)[1].label, "good");
    EXPECT_EQ(candidates_for(wish_from("24dB"), kPoints)[2].label, "quick");
}

TEST(Candidates, ABudgetIsSpentOnTheMostAccurate) {
    EXPECT_EQ(candidates_for(wish_from("30fps"), kPoints)[0].label, "middle");
    EXPECT_EQ(candidates_for(wish_from("50s"), kPoints)[0].label, "middle");
    EXPECT_EQ(candidates_for(wish_from("2min"), kPoints)[0].label, "good");
}

TEST(Candidates, WhatLeavesThePictureEmptyIsTheLastResort) {
    std::vector<ChartPoint> points = kPoints;
    for (ChartPoint& point : points) point.mean.coverage = 0.98;
    points.push_back(point("nearly empty", 5, 2, 0.05, 8));
    points.back().mean.coverage = 0.03;
    for (const char* wish : {"30fps", "300fps", "50s", "5dB"}) {
        EXPECT_EQ(candidates_for(wish_from(wish), points).back().label, "nearly empty") << wish;
    }
}

TEST(Candidates, WhatIsOutOfReachIsApproached) {
    EXPECT_EQ(candidates_for(wish_from("40dB"), kPoints)[0].label, "good");
    EXPECT_EQ(candidates_for(wish_from("500fps"), kPoints)[0].label, "quick");
}

TEST(PutCheapestFirst, GoesByPixelsAndByTheDepthModel) {
    Sweep sweep;
    for (const int width_px : {800, 400}) {
        for (const char* model : {"sweep", "plane", "auto"}) {
            Variant variant{{}, model + std::to_string(width_px), {}};
            variant.config.ingest.max_width_px = width_px;
            variant.config.depth.model = model;
            sweep.variants.push_back(std::move(variant));
        }
    }
    put_cheapest_first(sweep);
    std::vector<std::string> order;
    for (const Variant& variant : sweep.variants) order.push_back(variant.label);
    EXPECT_EQ(order, (std::vector<std::string>{"plane400", "sweep400", "auto400", "plane800",
                                               "sweep800", "auto800"}));
}

/// One variant for each size, of photographs that lie in a folder.
std::vector<std::string> variants_in_order(const std::vector<int>& widths_px,
                                           const std::filesystem::path& photographs,
                                           const std::vector<std::string>& models) {
    Sweep sweep;
    for (const std::string& model : models) {
        for (const int width_px : widths_px) {
            Variant variant{{}, model + std::to_string(width_px), {}};
            variant.config.photographs_or_video = photographs;
            variant.config.ingest.max_width_px = width_px;
            variant.config.depth.model = model;
            sweep.variants.push_back(std::move(variant));
        }
    }
    put_cheapest_first(sweep);
    std::vector<std::string> order;
    for (const Variant& variant : sweep.variants) order.push_back(variant.label);
    return order;
}

TEST(PutCheapestFirst, PhotographsAsTheyAreCountByTheirSize) {
    const ScratchFolder scratch;
    write_png(scratch / "one.png", ColorImage(120, 200));
    EXPECT_EQ(variants_in_order({0, 100}, scratch.path(), {"plane"}),
              (std::vector<std::string>{"plane100", "plane0"}));
    // A dear model of small copies is dearer than the cheapest of photographs as they are.
    EXPECT_EQ(variants_in_order({0, 160}, scratch.path(), {"plane", "patch_match"}),
              (std::vector<std::string>{"plane160", "plane0", "patch_match160", "patch_match0"}));
    // None is enlarged: these cost the same.
    EXPECT_EQ(variants_in_order({0, 4000, 300}, scratch.path(), {"plane"}),
              (std::vector<std::string>{"plane0", "plane4000", "plane300"}));
}

TEST(PutCheapestFirst, AVideoAsItIsIsTheDearest) {
    EXPECT_EQ(variants_in_order({0, 1920, 960}, "walk.mp4", {"sweep", "plane"}),
              (std::vector<std::string>{"plane960", "sweep960", "plane1920", "sweep1920", "plane0",
                                        "sweep0"}));
}

TEST(EndsTheSweep, WithTheFirstThatIsAccurateEnough) {
    MeasuredVariant variant;
    ModeScores mode;
    mode.views.resize(1);
    mode.views.front().psnr_db = 25;
    variant.scores.push_back(mode);
    EXPECT_TRUE(ends_the_sweep(wish_from("24dB"), variant));
    EXPECT_FALSE(ends_the_sweep(wish_from("26dB"), variant));
    EXPECT_FALSE(ends_the_sweep(wish_from("24dB"), MeasuredVariant{}));
}

TEST(EndsTheSweep, ForABudgetOnlyWhereThereIsSurelyNoTime) {
    MeasuredVariant variant;
    variant.stages.push_back({"poses", {40.0}, {30.0}});
    variant.stages.push_back({"depth", {80.0}, {60.0}});
    EXPECT_TRUE(ends_the_sweep(wish_from("50s"), variant));
    EXPECT_FALSE(ends_the_sweep(wish_from("80s"), variant));
    EXPECT_FALSE(ends_the_sweep(wish_from("2min"), variant));
    EXPECT_FALSE(ends_the_sweep(wish_from("1000MiB"), variant));
    EXPECT_FALSE(ends_the_sweep(wish_from("500fps"), variant));
}

}  // namespace
}  // namespace lumi
