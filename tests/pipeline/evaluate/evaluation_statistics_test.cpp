#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pipeline/evaluate/bootstrap.h"
#include "pipeline/evaluate/edge_sharpness.h"
#include "pipeline/evaluate/gain_fit.h"
#include "pipeline/evaluate/rank_correlation.h"

namespace lumi {
namespace {

ColorImage waves(int width, int height, double contrast) {
    ColorImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto value = static_cast<std::uint8_t>(std::lround(
                128 + contrast * (x % 8 < 4 ? 1 : -1) + contrast * (y % 10 < 5 ? 1 : -1)));
            image(x, y) = {value, value, value};
        }
    }
    return image;
}

TEST(Bootstrap, IsTheSameForTheSameSeed) {
    const std::vector<double> values{1, 5, 2, 8, 3, 9};
    const Interval first = *bootstrap_interval(values, {.seed = 7});
    const Interval again = *bootstrap_interval(values, {.seed = 7});
    EXPECT_EQ(first.low, again.low);
    EXPECT_EQ(first.high, again.high);
}

TEST(Bootstrap, EqualValuesHaveNoSpread) {
    const Interval equal = *bootstrap_interval(std::vector<double>(kFewestForInterval, 3.0));
    EXPECT_EQ(equal.low, 3.0);
    EXPECT_EQ(equal.high, 3.0);
}

TEST(Bootstrap, TellsNoIntervalOfFewerValuesThanItHoldsFor) {
    EXPECT_FALSE(bootstrap_interval({}).has_value());
    EXPECT_FALSE(bootstrap_interval({3.0}).has_value());
    EXPECT_FALSE(bootstrap_interval({1.0, 2.0}).has_value());
    EXPECT_FALSE(bootstrap_interval({1.0, 2.0, 3.0, 4.0, 5.0}).has_value());
    EXPECT_TRUE(bootstrap_interval({1.0, 2.0, 3.0, 4.0, 5.0, 6.0}).has_value());
}

TEST(Bootstrap, OfTheFewestHoldsTheTrueMeanNearlyAsOftenAsItSays) {
    std::mt19937 random(6);
    std::normal_distribution<double> values(10.0, 2.0);
    int held = 0;
    constexpr int kTrials = 1000;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<double> sample(kFewestForInterval);
        for (double& value : sample) value = values(random);
        const Interval interval = *bootstrap_interval(sample, {.resamples = 300});
        if (interval.low <= 10.0 && interval.high >= 10.0) ++held;
    }
    EXPECT_GT(held, kTrials * 0.82);
}

TEST(Range, IsFromTheLeastToTheGreatest) {
    EXPECT_FALSE(range_of(std::vector<double>()).has_value());
    const Interval range = *range_of({2.0, -1.0, 5.0, 3.0});
    EXPECT_EQ(range.low, -1.0);
    EXPECT_EQ(range.high, 5.0);
}

TEST(Bootstrap, HoldsTheTrueMeanAsOftenAsItSays) {
    std::mt19937 random(5);
    std::normal_distribution<double> values(10.0, 2.0);
    int held = 0;
    constexpr int kTrials = 400;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<double> sample(40);
        for (double& value : sample) value = values(random);
        const Interval interval = *bootstrap_interval(sample, {.resamples = 400});
        if (interval.low <= 10.0 && interval.high >= 10.0) ++held;
    }
    // The percentile interval is a little short for 40 values.
    EXPECT_GT(held, kTrials * 0.90);
    EXPECT_LT(held, kTrials * 0.98);
}

TEST(RankCorrelation, IsOneForAnyRisingRelation) {
    EXPECT_DOUBLE_EQ(*rank_correlation({1, 2, 3, 4}, {1, 8, 27, 1000}), 1.0);
    EXPECT_DOUBLE_EQ(*rank_correlation({1, 2, 3, 4}, {9, 4, 2, -1}), -1.0);
}

TEST(RankCorrelation, EqualValuesShareTheirRank) {
    // Ranks 0.5 0.5 2 3 and 0 1 2 3: by hand 4.5 / sqrt(4.5 * 5).
    EXPECT_NEAR(*rank_correlation({7, 7, 8, 9}, {1, 2, 3, 4}), 4.5 / std::sqrt(4.5 * 5.0), 1e-12);
}

TEST(RankCorrelation, NeedsSpread) {
    EXPECT_FALSE(rank_correlation({1, 2}, {1, 2}).has_value());
    EXPECT_FALSE(rank_correlation({1, 1, 1}, {1, 2, 3}).has_value());
}

TEST(GainFit, FindsGainAndBiasOfEachChannel) {
    const ColorImage photograph = waves(40, 40, 40);
    ColorImage rendering = photograph;
    for (Rgb8& pixel : rendering.pixels()) {
        // photograph = 2 * rendering - 20 in red; 1 * rendering + 10 in blue.
        pixel.r = static_cast<std::uint8_t>((pixel.r + 20) / 2);
        pixel.b = static_cast<std::uint8_t>(pixel.b - 10);
    }
    const GainFit fit = *fit_gain(photograph, rendering, GrayImage(40, 40, 255));
    EXPECT_NEAR(fit.gain[0], 2.0, 1e-9);
    EXPECT_NEAR(fit.bias[0], -20.0, 1e-6);
    EXPECT_NEAR(fit.gain[1], 1.0, 1e-9);
    EXPECT_NEAR(fit.gain[2], 1.0, 1e-9);
    EXPECT_NEAR(fit.bias[2], 10.0, 1e-6);
    EXPECT_GT(fit.psnr_db, 90.0);
}

TEST(GainFit, NothingCoveredHasNoFit) {
    EXPECT_FALSE(fit_gain(waves(9, 9, 5), waves(9, 9, 5), GrayImage(9, 9, 0)).has_value());
}

TEST(EdgeSharpness, GrowsWithTheSquareOfContrast) {
    const GrayImage coverage(40, 40, 255);
    EXPECT_DOUBLE_EQ(*edge_sharpness(waves(40, 40, 40), waves(40, 40, 40), coverage), 1.0);
    EXPECT_NEAR(*edge_sharpness(waves(40, 40, 40), waves(40, 40, 20), coverage), 0.25, 1e-9);
}

TEST(EdgeSharpness, APhotographWithoutEdgesHasNone) {
    const ColorImage grey(20, 20, {90, 90, 90});
    EXPECT_FALSE(edge_sharpness(grey, grey, GrayImage(20, 20, 255)).has_value());
}

}  // namespace
}  // namespace lumi
