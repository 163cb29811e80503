#include "meshing/exposure/exposure_gains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "calib/pictures/lost_color.h"
#include "tests/meshing/exposure/exposed_wall.h"

namespace lumi {
namespace {

constexpr int kViews = 8;

ExposureGains gains_of(ExposedWall& wall) {
    const std::vector<PicturedView> views = wall.views();
    return exposure_gains(static_cast<int>(views.size()),
                          exposure_ratios(shared_tiles(views, 1, SilentProgress()), 0.0));
}

/// Exposes every photograph by its factors, and expects the gains that undo them, but for the
/// factor that all have in common.
void expect_recovered(ExposedWall& wall, bool by_channel, ExposureModel model) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> stops(-0.8, 0.1);
    std::vector<Eigen::Array3d> factors;
    for (int i = 0; i < kViews; ++i) {
        const double all = stops(random);
        factors.emplace_back(Eigen::Array3d::Constant(std::exp2(all)));
        if (by_channel) {
            for (double& factor : factors.back()) factor *= std::exp2(0.3 * stops(random));
        }
        wall.expose(i, factors.back());
    }
    const ExposureGains found = gains_of(wall);
    EXPECT_EQ(found.model, model);
    EXPECT_GT(found.difference_stops, 0.1);
    EXPECT_LT(found.remaining_stops, 0.02);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        double mean_log = 0;
        double product_log = 0;
        for (std::size_t i = 0; i < kViews; ++i) {
            const double gain = found.gains[i][channel];
            mean_log += std::log(gain) / kViews;
            product_log += std::log(gain * factors[i][static_cast<Eigen::Index>(channel)]) / kViews;
        }
        EXPECT_NEAR(mean_log, 0.0, 1e-9);
        for (std::size_t i = 0; i < kViews; ++i) {
            const double undone =
                found.gains[i][channel] * factors[i][static_cast<Eigen::Index>(channel)];
            EXPECT_NEAR(undone / std::exp(product_log), 1.0, 0.01) << i << " " << channel;
        }
    }
}

TEST(ExposureGains, UndoExposuresToOnePercent) {
    ExposedWall wall(kViews);
    expect_recovered(wall, false, ExposureModel::kGain);
}

TEST(ExposureGains, UndoWhiteBalanceToOnePercentInSpiteOfHighlights) {
    ExposedWall wall(kViews);
    wall.add_highlights();
    expect_recovered(wall, true, ExposureModel::kChannelGains);
}

TEST(ExposureGains, UndoTheExposureOfAFewAmongMany) {
    ExposedWall wall(kViews);
    wall.add_noise(2.0);
    for (const int view : {2, 5}) wall.expose(view, Eigen::Array3d::Constant(0.5));
    const ExposureGains found = gains_of(wall);
    EXPECT_NE(found.model, ExposureModel::kNone);
    EXPECT_LT(found.remaining_stops, 0.1 * found.difference_stops);
    for (const std::size_t view : {2U, 5U}) {
        EXPECT_NEAR(found.gains[view][1] / found.gains[0][1], 2.0, 0.05) << view;
    }
}

TEST(ExposureGains, AreNoneWherePhotographsDoNotDiffer) {
    ExposedWall plain(kViews);
    EXPECT_EQ(gains_of(plain).model, ExposureModel::kNone);
    ExposedWall noisy(kViews);
    noisy.add_noise(4.0);
    noisy.add_highlights();
    const ExposureGains found = gains_of(noisy);
    EXPECT_EQ(found.model, ExposureModel::kNone);
    EXPECT_GT(found.pairs, kViews);
    for (const auto& gain : found.gains) EXPECT_EQ(gain, (std::array<double, 3>{1, 1, 1}));
}

/// Of eight exposures, with what surfaces shine differently in each pair.
ExposureGains gains_beside_shine(double shine_sigma) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    std::vector<double> logs(kViews);
    for (double& value : logs) value = 0.1 * normal(random);
    std::vector<ExposureRatio> ratios;
    for (int first = 0; first < kViews; ++first) {
        for (int second = first + 1; second < kViews; ++second) {
            const double ratio = logs[static_cast<std::size_t>(second)] -
                                 logs[static_cast<std::size_t>(first)] +
                                 shine_sigma * normal(random);
            const Eigen::Vector3d of_pair = Eigen::Vector3d::Constant(ratio);
            ratios.push_back({first, second, {of_pair, of_pair}, 0.02});
        }
    }
    return exposure_gains(kViews, ratios);
}

TEST(ExposureGains, AreNoneWherePhotographsMostlyDifferByHowSurfacesShine) {
    EXPECT_EQ(gains_beside_shine(0.002).model, ExposureModel::kGain);
    const ExposureGains found = gains_beside_shine(0.1);
    EXPECT_EQ(found.model, ExposureModel::kNone);
    EXPECT_EQ(found.difference_stops, found.remaining_stops);
}

TEST(ExposureGains, AreNoneWhereNothingCanBeCompared) {
    ExposedWall one(1);
    EXPECT_EQ(gains_of(one).model, ExposureModel::kNone);
    ExposedWall black(2);
    for (const int view : {0, 1}) black.expose(view, Eigen::Array3d::Constant(1e-4));
    const ExposureGains found = gains_of(black);
    EXPECT_EQ(found.model, ExposureModel::kNone);
    EXPECT_EQ(found.pairs, 0);
    EXPECT_EQ(exposure_gains(0, {}).gains.size(), 0U);
    for (const std::uint8_t confidence : {std::uint8_t{0}, kFilledBeforeBackground}) {
        ExposedWall guessed(kViews);
        guessed.forget_depth(confidence);
        EXPECT_EQ(gains_of(guessed).pairs, 0) << static_cast<int>(confidence);
    }
}

TEST(ExposureGains, HaveAGeometricMeanOfOneHoweverLargeTheyAre) {
    const std::vector<double> log_factors{12.0, -0.4, -0.2, 0.0, 0.2, 0.4};  // The first is absurd.
    std::vector<ExposureRatio> ratios;
    for (std::size_t second = 1; second < log_factors.size(); ++second) {
        for (std::size_t first = 0; first < second; ++first) {
            const Eigen::Vector3d both =
                Eigen::Vector3d::Constant(log_factors[second] - log_factors[first]);
            ratios.push_back(
                {static_cast<int>(first), static_cast<int>(second), {both, both}, 0.0});
        }
    }
    const ExposureGains found = exposure_gains(static_cast<int>(log_factors.size()), ratios);
    ASSERT_NE(found.model, ExposureModel::kNone);
    double sum_of_logs = 0;
    for (const auto& gain : found.gains) sum_of_logs += std::log(gain[0]);
    EXPECT_NEAR(sum_of_logs, 0.0, 1e-9);
    EXPECT_GT(found.largest_stops, 1.5);
}

/// Of two photographs, or three that meet in one of them, whose tiles differ by this on average,
/// and scatter by 0.1.
ExposureModel model_of_few(int views, double log_ratio, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0.0, 0.1);
    std::vector<SharedTiles> pairs;
    for (int second = 1; second < views; ++second) {
        SharedTiles& pair = pairs.emplace_back(SharedTiles{0, second, {}});
        for (std::size_t i = 0; i < 40; ++i) {
            const double tile = log_ratio + normal(random);
            pair.tiles.push_back({i % 2, Eigen::Vector3d::Constant(tile), 0.0});
        }
    }
    return exposure_gains(views, exposure_ratios(pairs, 0.0)).model;
}

TEST(ExposureGains, OfTwoOrThreePhotographsAreToldFromChance) {
    constexpr unsigned kTrials = 200;
    for (const int views : {2, 3}) {
        unsigned of_chance = 0;
        unsigned of_exposure = 0;
        for (unsigned seed = 0; seed < kTrials; ++seed) {
            if (model_of_few(views, 0.0, seed) != ExposureModel::kNone) ++of_chance;
            if (model_of_few(views, 0.3, seed) == ExposureModel::kGain) ++of_exposure;
        }
        // Beyond a standard error of the tiles chance comes one time in six, and of that some is
        // less than what the two colours differ by.
        EXPECT_LT(of_chance, kTrials / 10) << views;
        EXPECT_GT(of_exposure, kTrials * 9 / 10) << views;
    }
}

/// Exact ratios along a chain and across it, a fifth of them wrong.
TEST(ExposureGains, OutvoteWrongRatios) {
    constexpr int kCount = 20;
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0.0, 0.3);
    std::vector<double> log_factors;
    for (int i = 0; i < kCount; ++i) log_factors.push_back(normal(random));
    std::vector<ExposureRatio> ratios;
    for (int i = 0; i < kCount; ++i) {
        for (int step = 1; step <= 4 && i + step < kCount; ++step) {
            const auto index = static_cast<std::size_t>(i);
            const double log_ratio =
                log_factors[index + static_cast<std::size_t>(step)] - log_factors[index];
            const double wrong = ratios.size() % 5 == 4 ? 0.4 : 0.0;
            const Eigen::Vector3d both = Eigen::Vector3d::Constant(log_ratio + wrong);
            ratios.push_back({i, i + step, {both, both}, 0.01});
        }
    }
    const ExposureGains found = exposure_gains(kCount, ratios);
    ASSERT_EQ(found.model, ExposureModel::kGain);
    for (std::size_t i = 1; i < kCount; ++i) {
        const double undone = found.gains[i][0] / found.gains[0][0];
        EXPECT_NEAR(undone, std::exp(log_factors[0] - log_factors[i]), 0.01 * undone);
    }
}

/// Around a turned object neighbours differ by what light does to it, not alike in all tiles: what
/// adds up to stops at its far side is no exposure.
TEST(ExposureGains, DoNotAddUpWhereTilesDisagree) {
    constexpr int kCount = 40;
    const auto ratios_with = [](double spread) {
        std::vector<ExposureRatio> ratios;
        for (int i = 0; i < kCount; ++i) {
            const double log_ratio = i < kCount / 2 ? 0.1 : -0.1;
            const Eigen::Vector3d both = Eigen::Vector3d::Constant(log_ratio);
            ratios.push_back({i, (i + 1) % kCount, {both, both}, spread});
        }
        return ratios;
    };
    EXPECT_GT(exposure_gains(kCount, ratios_with(0.01)).largest_stops, 1.0);
    EXPECT_LT(exposure_gains(kCount, ratios_with(0.3)).largest_stops, 0.5);
}

/// Exposed wall, of which one photograph is black and white.
TEST(ExposureGains, OfABlackAndWhitePhotographAreOneForAllChannelsAndLeaveTheOthersAsTheyAre) {
    const auto wall_with = [](bool is_colorless) {
        ExposedWall wall(kViews);
        for (int i = 0; i < kViews; ++i) {
            const double stops = 0.3 * (i % 3) - 0.9;
            wall.expose(i, Eigen::Array3d(std::exp2(stops), std::exp2(0.7 * stops),
                                          std::exp2(1.3 * stops)));
        }
        wall.expose(4, Eigen::Array3d::Constant(0.7));
        if (is_colorless) wall.photograph(4) = without_color(wall.photograph(4));
        return wall;
    };
    ExposedWall colored = wall_with(false);
    ExposedWall mixed = wall_with(true);
    const ExposureGains all = gains_of(colored);
    const ExposureGains found = gains_of(mixed);
    EXPECT_EQ(all.tell_white_balance, std::vector<char>(kViews, 1));
    ASSERT_EQ(found.model, ExposureModel::kChannelGains);
    for (std::size_t i = 0; i < kViews; ++i)
        EXPECT_EQ(found.tell_white_balance[i], i == 4 ? 0 : 1) << i;
    EXPECT_NEAR(found.gains[4][0], found.gains[4][1], 1e-9);
    EXPECT_NEAR(found.gains[4][2], found.gains[4][1], 1e-9);
    for (std::size_t i = 0; i < kViews; ++i) {
        if (i == 4) continue;
        for (const std::size_t channel : {0U, 1U, 2U}) {
            const double beside_first = found.gains[i][channel] / found.gains[0][channel];
            EXPECT_NEAR(beside_first, all.gains[i][channel] / all.gains[0][channel], 0.01)
                << i << " " << channel;
        }
    }
}

TEST(ExposureGains, OfBlackAndWhitePhotographsAloneAreFoundAsOfAnyOthers) {
    ExposedWall wall(kViews);
    for (int i = 0; i < kViews; ++i) wall.photograph(i) = without_color(wall.photograph(i));
    expect_recovered(wall, false, ExposureModel::kGain);
}

}  // namespace
}  // namespace lumi
