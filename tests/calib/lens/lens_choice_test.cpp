#include "calib/lens/lens_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lumi {
namespace {

/// Folds of 100 residuals with these mean squares.
std::vector<HeldOutFold> folds_of(const std::vector<double>& mean_squares_px2) {
    std::vector<HeldOutFold> folds;
    for (const double value : mean_squares_px2) folds.push_back({100 * value, 100});
    return folds;
}

LensTrial trial_of(const LensForm& form, double residual_sum_px2, std::vector<HeldOutFold> folds) {
    LensTrial trial;
    trial.form = form;
    trial.residual_sum_px2 = residual_sum_px2;
    trial.residuals = 1000;
    trial.folds = std::move(folds);
    return trial;
}

const LensForm kSimple = all_free(LensModel::kSimplePinhole);
const LensForm kMiddle = all_free(LensModel::kRadial);
const LensForm kRich = all_free(LensModel::kFullOpenCv);

TEST(LensChoice, TakesTheSimplestWithinOneStandardErrorOfTheBest) {
    // Differences of SIMPLE_PINHOLE to FULL_OPENCV: 0.2 in every fold. Of RADIAL: -0.02 to 0.03.
    const LensChoice choice =
        choose_lens({trial_of(kRich, 100, folds_of({0.10, 0.20, 0.30, 0.15})),
                     trial_of(kSimple, 300, folds_of({0.30, 0.41, 0.50, 0.34})),
                     trial_of(kMiddle, 110, folds_of({0.13, 0.18, 0.32, 0.13}))});
    ASSERT_EQ(choice.trials.size(), 3u);
    EXPECT_EQ(choice.choice().form, kMiddle);
    EXPECT_EQ(choice.trials[choice.best_predicting].form, kRich);
    EXPECT_EQ(choice.trials[0].form, kSimple);
    EXPECT_NEAR(choice.trials[0].excess_px2, 0.2, 1e-12);
}

TEST(LensChoice, WhatMakesAPhotographHardIsNoExcuse) {
    // Folds differ tenfold, and yet the richer form is better in each of them by the same.
    const LensChoice choice =
        choose_lens({trial_of(kSimple, 110, folds_of({0.12, 0.52, 1.02, 0.22})),
                     trial_of(kMiddle, 100, folds_of({0.10, 0.50, 1.00, 0.20}))});
    EXPECT_EQ(choice.choice().form, kMiddle);
    EXPECT_NEAR(choice.trials[0].excess_px2, 0.02, 1e-12);
    EXPECT_NEAR(choice.trials[0].excess_sigma_px2, 0.0, 1e-12);
}

TEST(LensChoice, WhatNobodyCouldSeeIsNoReasonForARicherForm) {
    // Surely better, in every fold by the same: by 0.8 % of the mean square, then by 1.2 %.
    const auto chosen = [](double excess_px2) {
        return choose_lens({trial_of(kSimple, 110, folds_of({0.1 + excess_px2, 0.3 + excess_px2})),
                            trial_of(kRich, 100, folds_of({0.1, 0.3}))})
            .choice()
            .form;
    };
    EXPECT_EQ(chosen(0.008 * 0.2), kSimple);
    EXPECT_EQ(chosen(0.012 * 0.2), kRich);
}

TEST(LensChoice, StandardErrorIsThatOfTheMeanOfFolds) {
    const LensChoice choice = choose_lens({trial_of(kSimple, 110, folds_of({0.2, 0.4, 0.3})),
                                           trial_of(kMiddle, 100, folds_of({0.1, 0.1, 0.1}))});
    // Differences 0.1, 0.3, 0.2: standard deviation 0.1 of three.
    EXPECT_NEAR(choice.trials[0].excess_px2, 0.2, 1e-12);
    EXPECT_NEAR(choice.trials[0].excess_sigma_px2, 0.1 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(choice.trials[0].held_out_rms_px, std::sqrt(0.3), 1e-12);
}

TEST(LensChoice, PrintsBicBesideIt) {
    const LensChoice choice = choose_lens({trial_of(kSimple, 300, folds_of({0.3, 0.3})),
                                           trial_of(kMiddle, 100, folds_of({0.3, 0.3}))});
    EXPECT_NEAR(choice.trials[0].bic, 1000 * std::log(0.3) + 3 * std::log(1000.0), 1e-9);
    EXPECT_NEAR(choice.trials[1].bic, 1000 * std::log(0.1) + 5 * std::log(1000.0), 1e-9);
    EXPECT_EQ(choice.choice().form, kSimple);
    EXPECT_EQ(choice.trials[choice.least_bic].form, kMiddle);
    const std::string table = lens_choice_table(choice);
    EXPECT_NE(table.find("SIMPLE_PINHOLE"), std::string::npos) << table;
    EXPECT_NE(table.find("chosen"), std::string::npos) << table;
    EXPECT_NE(table.find("least BIC"), std::string::npos) << table;
}

TEST(LensChoice, BicDecidesWhereNothingWasHeldOut) {
    const LensChoice choice = choose_lens(
        {trial_of(kSimple, 300, {}), trial_of(kMiddle, 100, {}), trial_of(kRich, 99.9, {})});
    EXPECT_EQ(choice.choice().form, kMiddle);
}

TEST(LensChoice, BicDecidesWhereNoFoldIsUsable) {
    const std::vector<HeldOutFold> unusable(3);
    const LensChoice choice =
        choose_lens({trial_of(kSimple, 300, unusable), trial_of(kMiddle, 100, unusable),
                     trial_of(kRich, 99.9, unusable)});
    EXPECT_EQ(choice.choice().form, kMiddle);
    for (const LensTrial& trial : choice.trials) {
        EXPECT_TRUE(trial.folds.empty());
        EXPECT_EQ(trial.excess_sigma_px2, 0.0);
    }
    EXPECT_FALSE(predicts_worse_surely(unusable, unusable));
}

TEST(LensChoice, UnusableFoldsAreSkipped) {
    std::vector<HeldOutFold> simple = folds_of({0.2, 0.4, 0.3});
    std::vector<HeldOutFold> middle = folds_of({0.1, 0.1, 0.1});
    const LensChoice whole =
        choose_lens({trial_of(kSimple, 110, simple), trial_of(kMiddle, 100, middle)});
    simple.insert(simple.begin() + 1, 4, HeldOutFold{});
    middle.insert(middle.begin() + 1, 4, HeldOutFold{});
    const LensChoice choice =
        choose_lens({trial_of(kSimple, 110, simple), trial_of(kMiddle, 100, middle)});
    EXPECT_EQ(choice.choice().form, whole.choice().form);
    EXPECT_EQ(choice.trials[0].excess_px2, whole.trials[0].excess_px2);
    EXPECT_EQ(choice.trials[0].excess_sigma_px2, whole.trials[0].excess_sigma_px2);
}

TEST(LensChoice, AFormWithoutFoldsIsNotChosenBesideOthers) {
    LensTrial without = trial_of(kSimple, 50, {});
    without.not_predicted = "not tried";
    const LensChoice choice = choose_lens({without, trial_of(kMiddle, 100, folds_of({0.1, 0.2}))});
    EXPECT_EQ(choice.choice().form, kMiddle);
    EXPECT_NE(lens_choice_table(choice).find("not tried"), std::string::npos);
}

TEST(LensChoice, AFaultInTheUnseenCornersIsAvoidedWhereNothingSurelyPredictsWorse) {
    // Differences 0.1, 0.3, 0.2: 3.5 standard errors of their mean. 0.1, 0.3, 0.0: 1.5 of them.
    LensTrial folding = trial_of(kRich, 100, folds_of({0.1, 0.1, 0.1}));
    folding.fault_beyond_seen = "folds over within the picture";
    const LensTrial worse = trial_of(kSimple, 300, folds_of({0.2, 0.4, 0.3}));
    const LensTrial doubtful = trial_of(kMiddle, 110, folds_of({0.2, 0.4, 0.1}));
    EXPECT_EQ(choose_lens({folding, worse}).choice().form, kRich);
    EXPECT_EQ(choose_lens({folding, worse, doubtful}).choice().form, kMiddle);
}

TEST(LensChoice, APrincipalPointThatPhotographsHardlyTellCanBeLeftInTheMiddle) {
    // Differences of 0.0225 +- 0.0138.
    const LensForm held = with_principal_point_held(LensModel::kRadial);
    const LensChoice choice =
        choose_lens({trial_of(kMiddle, 100, folds_of({0.10, 0.20, 0.30, 0.15})),
                     trial_of(held, 120, folds_of({0.14, 0.19, 0.35, 0.16})),
                     trial_of(kSimple, 400, folds_of({0.40, 0.50, 0.60, 0.45}))});
    EXPECT_EQ(choice.choice().form, kMiddle);
    const auto index = choice_with_principal_point_held(choice);
    ASSERT_TRUE(index.has_value());
    EXPECT_EQ(choice.trials[*index].form, held);
}

TEST(LensChoice, APrincipalPointThatPhotographsSurelyTellCannot) {
    const LensForm held = with_principal_point_held(LensModel::kRadial);
    const LensChoice choice =
        choose_lens({trial_of(kMiddle, 100, folds_of({0.10, 0.20, 0.30, 0.15})),
                     trial_of(held, 500, folds_of({0.51, 0.60, 0.69, 0.55}))});
    EXPECT_EQ(choice_with_principal_point_held(choice), std::nullopt);
    EXPECT_EQ(choice_with_principal_point_held(
                  choose_lens({trial_of(kMiddle, 100, folds_of({0.10, 0.20}))})),
              std::nullopt);
}

TEST(LensChoice, SkipsFoldsOnlyWhereTheFitItselfIsWorse) {
    const std::vector<HeldOutFold> best = folds_of({0.10, 0.50, 0.11, 0.20});
    EXPECT_TRUE(predicts_worse_surely(folds_of({0.13, 0.54, 0.14, 0.24}), best));
    EXPECT_FALSE(predicts_worse_surely(folds_of({0.09, 0.54, 0.14, 0.19}), best));
    EXPECT_FALSE(predicts_worse_surely(best, best));
}

TEST(LensChoice, AmongEqualFormsTheSimplestIsChosenInMostDraws) {
    // Of forms that differ by noise alone, the one-standard-error rule takes the simplest with the
    // probability that the paired difference is below one standard error: 84 % and more.
    std::mt19937 random(5);
    std::normal_distribution<double> gaussian(0.0, 0.01);
    int simplest = 0;
    constexpr int kDraws = 400;
    for (int draw = 0; draw < kDraws; ++draw) {
        std::vector<double> simple;
        std::vector<double> rich;
        for (int fold = 0; fold < 10; ++fold) {
            simple.push_back(0.3 + gaussian(random));
            rich.push_back(0.3 + gaussian(random));
        }
        const LensChoice choice = choose_lens(
            {trial_of(kSimple, 300, folds_of(simple)), trial_of(kMiddle, 300, folds_of(rich))});
        simplest += choice.choice().form == kSimple ? 1 : 0;
    }
    EXPECT_GT(simplest, 0.78 * kDraws);
    EXPECT_LT(simplest, 0.90 * kDraws);
}

}  // namespace
}  // namespace lumi
