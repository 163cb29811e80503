#include "pipeline/evaluate/free_form_comparison.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

ViewScore score(double psnr_db, double cpu_ms) {
    return {.name = "x", .psnr_db = psnr_db, .cpu_ms = cpu_ms};
}

/// Two modes, and beside them what was resampled and what was not.
Evaluation evaluation_with_rivals() {
    Evaluation evaluation;
    evaluation.modes = {{RenderMode::kPerPixel, {score(35, 80)}, {}, {}},
                        {RenderMode::kAdaptive, {score(33, 20), score(35, 28)}, {}, {}}};
    evaluation.rivals = RivalEvaluation{
        {{"two-plane lightfield", {score(18, 6)}, 7.7},
         {"two-plane adaptive", {score(29, 18), score(30, 22)}, 7.7},
         {"forward warping", {score(32, 68)}, 0.0}},
        {},
        CommonPixelScores{
            0.5,
            {{"adaptive", 35.25}, {"two-plane adaptive", 30.25}, {"two-plane lightfield", 18.5}}}};
    return evaluation;
}

TEST(FreeFormComparison, IsOfTheSameModeOfPhotographsAndOfResampledPictures) {
    const auto compared = free_form_beside_resampled(evaluation_with_rivals());
    ASSERT_EQ(compared.size(), 1U) << "nothing was drawn in the mode lightfield beside the other";
    EXPECT_EQ(compared[0].mode, RenderMode::kAdaptive);
    EXPECT_EQ(compared[0].resampled, "two-plane adaptive");
    EXPECT_DOUBLE_EQ(compared[0].cpu_ratio.value(), 1.2);
    EXPECT_DOUBLE_EQ(compared[0].psnr_gain_db, 4.5);
    EXPECT_DOUBLE_EQ(compared[0].common_psnr_gain_db.value(), 5.0);
}

TEST(FreeFormComparison, SaysNothingOfWhatWasNotMeasured) {
    Evaluation evaluation = evaluation_with_rivals();
    evaluation.rivals->common.reset();
    evaluation.rivals->methods[1].views = {score(29, 0)};
    const auto compared = free_form_beside_resampled(evaluation);
    ASSERT_EQ(compared.size(), 1U);
    EXPECT_FALSE(compared[0].cpu_ratio.has_value());
    EXPECT_FALSE(compared[0].common_psnr_gain_db.has_value());
    evaluation.rivals.reset();
    EXPECT_TRUE(free_form_beside_resampled(evaluation).empty());
}

}  // namespace
}  // namespace lumi
