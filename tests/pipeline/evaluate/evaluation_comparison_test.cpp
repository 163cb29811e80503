#include "pipeline/evaluate/evaluation_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "pipeline/evaluate/evaluation_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

TEST(EvaluationComparison, IsViewByViewAndSaysWhatIsBeyondChance) {
    Evaluation a;
    a.modes = {{RenderMode::kPerPixel, {}, {}, {}}};
    Evaluation b = a;
    for (int i = 0; i < 8; ++i) {
        ViewScore view;
        view.name = std::to_string(i);
        view.psnr_db = 20.0 + i;
        view.ssim = 0.5 + 0.01 * i;
        a.modes[0].views.push_back(view);
        view.psnr_db += 0.5 + 0.01 * i;        // Better in every view, though views differ by more.
        view.ssim += i % 2 == 0 ? 0.1 : -0.1;  // Up and down.
        if (i > 0) b.modes[0].views.push_back(view);
    }
    const auto comparisons = compare_evaluations(evaluation_json(a), evaluation_json(b));
    ASSERT_EQ(comparisons.size(), 1U);
    EXPECT_EQ(comparisons[0].shared_views.size(), 7U);
    EXPECT_NEAR(*comparisons[0].metrics[0].mean_difference, 0.54, 1e-9);
    EXPECT_EQ(judgement_of(comparisons[0].metrics[0]), "better");
    EXPECT_EQ(judgement_of(comparisons[0].metrics[2]), "same");
}

/// So many views, each as much better than the one of the other evaluation as the one before.
Evaluation of_views(int count, double psnr_db, double ms) {
    Evaluation evaluation;
    evaluation.modes = {{RenderMode::kPerPixel, {}, {}, {}}};
    for (int i = 0; i < count; ++i) {
        evaluation.modes[0].views.push_back(
            ViewScore{.name = std::to_string(i), .psnr_db = psnr_db + i, .ms = ms + 0.01 * i});
    }
    return evaluation;
}

MetricComparison comparison_of(const Evaluation& a, const Evaluation& b, const char* metric) {
    const auto modes = compare_evaluations(evaluation_json(a), evaluation_json(b));
    const auto found =
        std::find_if(modes.at(0).metrics.begin(), modes.at(0).metrics.end(),
                     [&](const MetricComparison& candidate) { return candidate.metric == metric; });
    return *found;
}

TEST(EvaluationComparison, FewViewsAreNotJudgedHoweverMuchTheyAgree) {
    const auto of_count = [](int count) {
        return comparison_of(of_views(count, 20.0, 5.0), of_views(count, 21.0, 5.0), "psnr_db");
    };
    EXPECT_EQ(judgement_of(of_count(2)), "too few views");
    EXPECT_FALSE(of_count(2).interval);
    EXPECT_EQ(of_count(2).range->low, 1.0);
    EXPECT_EQ(judgement_of(of_count(5)), "too few views");
    EXPECT_EQ(judgement_of(of_count(6)), "better");
    // What is equal to the last bit is the same, whatever number of views say so.
    EXPECT_EQ(
        judgement_of(comparison_of(of_views(1, 20.0, 5.0), of_views(1, 20.0, 5.0), "psnr_db")),
        "same");
}

TEST(EvaluationComparison, TimesAreToldAsARatioAndNotJudged) {
    const MetricComparison ms =
        comparison_of(of_views(8, 20.0, 5.0), of_views(8, 20.0, 10.0), "ms");
    EXPECT_NEAR(*ms.ratio, 2.0, 0.01);
    EXPECT_FALSE(ms.interval);
    EXPECT_EQ(judgement_of(ms), "not judged");
}

TEST(EvaluationComparison, DifferentPhotographsOfOneNameAreRefused) {
    const auto refusal_of = [](const ViewScore& a, const ViewScore& b) -> std::string {
        Evaluation of_a;
        of_a.modes = {{RenderMode::kPerPixel, {a}, {}, {}}};
        Evaluation of_b;
        of_b.modes = {{RenderMode::kPerPixel, {b}, {}, {}}};
        try {
            static_cast<void>(compare_evaluations(evaluation_json(of_a), evaluation_json(of_b)));
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-EVAL-DISJOINT");
            return error.what();
        }
        return {};
    };
    const ViewScore view{.name = "x", .width_px = 256, .height_px = 170, .photograph_sha256 = "a"};
    EXPECT_EQ(refusal_of(view, view), "");
    ViewScore smaller = view;
    smaller.width_px = 128;
    smaller.height_px = 85;
    EXPECT_EQ(refusal_of(view, smaller), "x: 256 x 170 pixels in A and 128 x 85 in B");
    ViewScore other = view;
    other.photograph_sha256 = "b";
    EXPECT_NE(refusal_of(view, other).find("another photograph"), std::string::npos);
    // Evaluations of early versions do not say which photographs they are of.
    EXPECT_EQ(refusal_of(ViewScore{.name = "x"}, view), "");
}

TEST(EvaluationComparison, EvaluationsOfEarlyVersionsAreStillRead) {
    Json early = evaluation_json(of_views(6, 20.0, 5.0));
    early.erase("not_judged");
    for (Json& view : early["views"]) {
        for (const char* key : {"width_px", "height_px", "photograph_sha256"}) view.erase(key);
    }
    const auto modes = compare_evaluations(early, evaluation_json(of_views(6, 21.0, 5.0)));
    EXPECT_EQ(modes.at(0).shared_views.size(), 6U);
    EXPECT_EQ(mode_scores_from(RenderMode::kPerPixel, early).views.size(), 6U);
}

TEST(EvaluationComparison, NothingInCommonIsAnError) {
    Evaluation a;
    a.modes = {{RenderMode::kPerPixel, {ViewScore{.name = "x"}}, {}, {}}};
    Evaluation b;
    b.modes = {{RenderMode::kPerPixel, {ViewScore{.name = "y"}}, {}, {}}};
    EXPECT_THROW(static_cast<void>(compare_evaluations(evaluation_json(a), evaluation_json(b))),
                 Error);
}

}  // namespace
}  // namespace lumi
