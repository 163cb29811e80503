#include "pipeline/depth_bench/right_shares.h"

#include <gtest/gtest.h>

#include <random>

#include "pipeline/depth_bench/stability_trial.h"

namespace lumi {
namespace {

constexpr int kWidth = 80;
constexpr int kHeight = 60;
constexpr double kFocalLength = 100;
constexpr double kBaseline = 0.1;  // 10 px for each unit of inverse depth.

/// Two cameras side by side before noise.
DepthScene two_views() {
    std::mt19937 random(3);
    DepthScene scene;
    for (int i = 0; i < 2; ++i) {
        DepthView view;
        view.camera = pinhole_camera(kWidth, kHeight, kFocalLength);
        view.cam_from_world.translation = {-kBaseline * i, 0, 0};
        view.photograph = ColorImage(kWidth, kHeight);
        for (Rgb8& pixel : view.photograph.pixels()) {
            pixel.r = pixel.g = pixel.b = static_cast<std::uint8_t>(random() % 256);
        }
        view.neighbours = {1 - i};
        view.disparity_px_per_inverse_depth = kFocalLength * kBaseline;
        scene.views.push_back(std::move(view));
    }
    return scene;
}

DepthMap wall(float inverse_depth) {
    return {FloatImage(kWidth, kHeight, inverse_depth), GrayImage(kWidth, kHeight, 255)};
}

TEST(RightShares, AreThoseOfThePixelsWithinOnePixelOfDisparity) {
    const DepthScene scene = two_views();
    const std::vector<DepthMap> truth(2, wall(0.5F));
    EXPECT_EQ(right_shares(scene, truth, truth).of_visible, 1.0);
    EXPECT_EQ(right_shares(scene, truth, {wall(0.59F), wall(0.41F)}).of_visible, 1.0);
    EXPECT_EQ(right_shares(scene, truth, {wall(0.61F), wall(0.39F)}).of_visible, 0.0);
    std::vector<DepthMap> half = truth;
    for (DepthMap& map : half) {
        for (int y = 0; y < kHeight / 2; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                map.inverse_depth(x, y) = 0.9F;
                map.confidence(x, y) = 0;
            }
        }
    }
    EXPECT_EQ(right_shares(scene, truth, half).of_confident, 1.0);
    EXPECT_NEAR(right_shares(scene, truth, half).of_visible, 0.5, 1e-9);
}

TEST(RightShares, WhatNoNeighbourSeesOrHasNoTextureIsNotAsked) {
    const DepthScene scene = two_views();
    // A board before the second camera: none of what the first one sees is seen by two.
    const std::vector<DepthMap> truth{wall(0.5F), wall(2.0F)};
    const RightShares shares = right_shares(scene, truth, {wall(0.9F), truth[1]});
    EXPECT_EQ(shares.of_confident, 0.5);
    EXPECT_EQ(shares.of_visible, 1.0);
    DepthScene plain = two_views();
    for (DepthView& view : plain.views) view.photograph = ColorImage(kWidth, kHeight);
    EXPECT_EQ(right_shares(plain, truth, truth).of_visible, 0.0);
    EXPECT_EQ(right_shares(plain, truth, truth).of_confident, 1.0);
}

/// Trials of the noise at all its strengths, in which the sweep is right so often.
std::vector<StabilityTrial> noise_trials(const std::vector<double>& right_shares) {
    std::vector<StabilityTrial> trials;
    const std::vector<double>& strengths = curve_of(DepthHazard::kNoise).strengths;
    for (std::size_t i = 0; i < right_shares.size(); ++i) {
        trials.push_back({DepthHazard::kNoise,
                          strengths[i],
                          1,
                          {{"sweep", right_shares[i], 0.9, 0.9, 0.0, false}}});
    }
    return trials;
}

TEST(DepthStability, BreaksWhereATenthIsLost) {
    const std::vector<double>& strengths = curve_of(DepthHazard::kNoise).strengths;
    const auto breaking = [](const std::vector<double>& shares) {
        return breaking_strength(noise_trials(shares), DepthHazard::kNoise, "sweep");
    };
    EXPECT_EQ(breaking({0.95, 0.93, 0.84, 0.3, 0.1}), strengths[2]);
    EXPECT_EQ(breaking({0.95, 0.93, 0.9, 0.9, 0.86}), std::nullopt);
    EXPECT_EQ(breaking({}), std::nullopt);
    std::vector<StabilityTrial> two_seeds = noise_trials({0.95, 0.93});
    two_seeds.push_back(two_seeds.back());
    two_seeds.back().rungs.front().right_share = 0.71;
    EXPECT_EQ(breaking_strength(two_seeds, DepthHazard::kNoise, "sweep"), strengths[1]);
}

TEST(DepthStability, ClaimsTooMuchWhoIsOftenWrongWhereItIsSure) {
    EXPECT_FALSE(claims_too_much({"sweep", 0.5, 0.5, 0.95, 0.0, false}));
    EXPECT_TRUE(claims_too_much({"sweep", 0.5, 0.5, 0.7, 0.0, false}));
    EXPECT_FALSE(claims_too_much({"sweep", 0.1, 0.05, 0.2, 0.0, false}))
        << "it hardly claims a thing";
    EXPECT_FALSE(claims_too_much({"sweep", 0.5, 0.5, 0.7, 0.0, true})) << "it says so";
}

TEST(PointsByTruth, IsTheRatioOfUnitsAndEmptyWhereFewPointsTell) {
    DepthScene scene = two_views();
    for (int k = 0; k < 30; ++k) {
        // A point at an outline, where truth is another surface, does not rule.
        scene.views[0].points.push_back({{k + 0.5, 10.5}, k == 0 ? 9.0 : 1.5});
    }
    const auto ratio = points_by_truth(scene, {wall(0.5F), wall(0.5F)});
    ASSERT_TRUE(ratio);
    EXPECT_NEAR(*ratio, 3.0, 1e-6);
    scene.views[0].points.resize(19);
    EXPECT_FALSE(points_by_truth(scene, {wall(0.5F), wall(0.5F)}));
}

}  // namespace
}  // namespace lumi
