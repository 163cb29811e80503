#include "pipeline/report/lens_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "pipeline/stages/lens_choice_json.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Json compared() {
    LensTrial simple;
    simple.form = with_principal_point_held(LensModel::kSimplePinhole);
    simple.residual_sum_px2 = 90;
    simple.residuals = 1000;
    simple.folds = {{10, 100}, {12, 100}};
    LensTrial rich = simple;
    rich.form = all_free(LensModel::kFullOpenCv);
    rich.folds.clear();
    rich.not_predicted = "more than BIC asks for";
    return lens_choice_json(choose_lens({simple, rich}));
}

TEST(LensTables, WhatWasNotMeasuredIsNullAndSaysWhy) {
    const Json forms = compared();
    ASSERT_EQ(forms.size(), 2u);
    EXPECT_EQ(forms[0].at("form"), "SIMPLE_PINHOLE, cx cy held");
    EXPECT_TRUE(forms[0].at("is_chosen").get<bool>());
    EXPECT_NEAR(forms[0].at("held_out_rms_px").get<double>(), std::sqrt(22.0 / 200), 1e-12);
    EXPECT_TRUE(forms[1].at("held_out_rms_px").is_null());
    EXPECT_EQ(forms[1].at("not_predicted"), "more than BIC asks for");
}

TEST(LensTables, ShowEveryParameterWithItsIntervalAndEveryFormThatWasCompared) {
    const Json lens{{"model", "SIMPLE_PINHOLE"},
                    {"width_px", 1000},
                    {"height_px", 800},
                    {"names", {"f", "cx", "cy"}},
                    {"parameters", {900.0, 500.0, 400.0}},
                    {"sigma", {2.0, 0.0, 0.0}},
                    {"dropped", {"k1 = 0.001 +- 0.002"}},
                    {"compared", compared()}};
    const std::string html = lens_table(lens);
    EXPECT_NE(html.find("3.92"), std::string::npos) << html;  // 1.96 standard deviations of f.
    EXPECT_NE(html.find("held"), std::string::npos);
    EXPECT_NE(html.find("k1 = 0.001"), std::string::npos);
    EXPECT_NE(html.find("FULL_OPENCV"), std::string::npos);
    EXPECT_NE(html.find("more than BIC asks for"), std::string::npos);
}

TEST(LensTables, AnImportedLensHasNoIntervals) {
    const Json lens{{"model", "SIMPLE_PINHOLE"},
                    {"width_px", 1000},
                    {"height_px", 800},
                    {"names", {"f", "cx", "cy"}},
                    {"parameters", {900, 500, 400}}};
    EXPECT_NE(lens_table(lens).find("900"), std::string::npos);
    EXPECT_EQ(pose_uncertainty_table(Json::object()), "");
}

TEST(LensTables, EveryPoseHasItsJitter) {
    const Json poses{{"views",
                      {{{"name", "a.jpg"},
                        {"jitter_px", 0.123},
                        {"position_sigma", 0.004},
                        {"rotation_sigma_deg", 0.01}}}}};
    const std::string html = pose_uncertainty_table(poses);
    EXPECT_NE(html.find("a.jpg"), std::string::npos);
    EXPECT_NE(html.find("0.123"), std::string::npos);
}

}  // namespace
}  // namespace lumi
