#include "meshing/filling/edge_aware_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "meshing/filling/receding_fill.h"

namespace lumi {
namespace {

constexpr int kWidth = 120;
constexpr int kHeight = 80;
constexpr float kOnePixel = 0.01F;

void fill_and_smooth(DepthMap& map, const ColorImage& photograph, float fallback) {
    continue_known_depth(map, FloatImage(kWidth, kHeight, fallback), kOnePixel);
    smooth_filled_depth(map, photograph, kOnePixel);
}

TEST(EdgeAwareFill, KeepsWhatIsKnown) {
    std::mt19937 random(11);
    DepthMap map{FloatImage(kWidth, kHeight), GrayImage(kWidth, kHeight)};
    ColorImage photograph(kWidth, kHeight);
    for (std::size_t i = 0; i < photograph.pixels().size(); ++i) {
        photograph.pixels()[i].g = static_cast<std::uint8_t>(random() % 256);
        map.inverse_depth.pixels()[i] = static_cast<float>(random() % 1000) / 1000.0F;
        map.confidence.pixels()[i] = random() % 4 == 0 ? 0 : 200;
    }
    const DepthMap before = map;
    fill_and_smooth(map, photograph, 0.5F);
    EXPECT_EQ(map.confidence, before.confidence);
    for (std::size_t i = 0; i < photograph.pixels().size(); ++i) {
        if (before.confidence.pixels()[i] == 0) continue;
        ASSERT_EQ(map.inverse_depth.pixels()[i], before.inverse_depth.pixels()[i]) << i;
    }
}

TEST(EdgeAwareFill, ContinuesTheBackgroundBesideAnObject) {
    // Object (near, bright) in columns 60 on, wall (far, dark) left; 45 to 59 unknown, all wall.
    DepthMap map{FloatImage(kWidth, kHeight, 0.2F), GrayImage(kWidth, kHeight, 255)};
    ColorImage photograph(kWidth, kHeight, {60, 60, 60});
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 45; x < kWidth; ++x) {
            if (x < 60) {
                map.confidence(x, y) = 0;
                map.inverse_depth(x, y) = 7.0F;
            } else {
                map.inverse_depth(x, y) = 0.9F;
                photograph(x, y) = {200, 200, 200};
            }
        }
    }
    fill_and_smooth(map, photograph, 0.5F);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 45; x < 60; ++x) {
            ASSERT_NEAR(map.inverse_depth(x, y), 0.2F, kOnePixel) << x << " " << y;
        }
    }
}

/// An object from column 60 on, a wall before column 45, and nothing known between.
DepthMap wall_and_object(float wall, float object) {
    DepthMap map{FloatImage(kWidth, kHeight, wall), GrayImage(kWidth, kHeight, 255)};
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 45; x < kWidth; ++x) {
            if (x < 60) map.confidence(x, y) = 0;
            map.inverse_depth(x, y) = object;
        }
    }
    return map;
}

TEST(EdgeAwareFill, ContinuesTheObjectWhereTheWallIsKnownToBeHidden) {
    DepthMap map = wall_and_object(0.2F, 0.9F);
    DepthMap hidden{FloatImage(kWidth, kHeight, 0.2F), GrayImage(kWidth, kHeight)};
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 52; x < 60; ++x) hidden.confidence(x, y) = 255;
    }
    const FloatImage beyond_px =
        continue_known_depth(map, FloatImage(kWidth, kHeight, 0.5F), kOnePixel, {}, hidden);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 45; x < 60; ++x) {
            ASSERT_NEAR(map.inverse_depth(x, y), x < 52 ? 0.2F : 0.9F, kOnePixel) << x << " " << y;
        }
    }
    EXPECT_EQ(beyond_px(55, kHeight / 2), 0.0F) << "it lies between what is known all the same";
}

TEST(EdgeAwareFill, ContinuesAsEverWhereNothingLiesBeforeWhatIsHidden) {
    DepthMap map = wall_and_object(0.2F, 0.9F);
    const DepthMap hidden{FloatImage(kWidth, kHeight, 0.95F), GrayImage(kWidth, kHeight, 255)};
    continue_known_depth(map, FloatImage(kWidth, kHeight, 0.5F), kOnePixel, {}, hidden);
    for (int x = 45; x < 60; ++x) ASSERT_NEAR(map.inverse_depth(x, 40), 0.2F, kOnePixel) << x;
}

TEST(EdgeAwareFill, ClosesAHoleInASlantedPlane) {
    DepthMap map{FloatImage(kWidth, kHeight), GrayImage(kWidth, kHeight, 255)};
    const auto plane = [](int x, int y) { return 0.2F + 0.001F * static_cast<float>(x + y); };
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            map.inverse_depth(x, y) = plane(x, y);
            if (x >= 50 && x < 70 && y >= 30 && y < 50) map.confidence(x, y) = 0;
        }
    }
    fill_and_smooth(map, ColorImage(kWidth, kHeight), 0.0F);
    for (int y = 30; y < 50; ++y) {
        for (int x = 50; x < 70; ++x) {
            ASSERT_NEAR(map.inverse_depth(x, y), plane(x, y), kOnePixel) << x << " " << y;
        }
    }
}

TEST(EdgeAwareFill, WithNothingKnownTakesTheFallback) {
    DepthMap map{FloatImage(kWidth, kHeight), GrayImage(kWidth, kHeight)};
    fill_and_smooth(map, ColorImage(kWidth, kHeight), 0.5F);
    for (const float value : map.inverse_depth.pixels()) ASSERT_NEAR(value, 0.5F, 1e-6F);
}

TEST(EdgeAwareFill, TellsHowFarItContinuedBeyondWhatIsKnown) {
    // Known on the left half alone: no pixel of the right one has known pixels on most sides.
    DepthMap map{FloatImage(kWidth, kHeight, 0.7F), GrayImage(kWidth, kHeight, 255)};
    for (int y = 0; y < kHeight; ++y) {
        for (int x = kWidth / 2; x < kWidth; ++x) map.confidence(x, y) = 0;
    }
    const FloatImage distance_px =
        continue_known_depth(map, FloatImage(kWidth, kHeight, 0.5F), kOnePixel);
    EXPECT_EQ(distance_px(kWidth / 2 - 1, 40), 0.0F);
    EXPECT_EQ(distance_px(kWidth / 2, 40), 1.0F);
    EXPECT_EQ(distance_px(kWidth - 1, 40), static_cast<float>(kWidth / 2));
    recede(0.5, kOnePixel, distance_px, map);
    EXPECT_NEAR(map.inverse_depth(kWidth / 2 + 19, 40), 0.7F - 0.5F * 20 * kOnePixel, 1e-5F);
    EXPECT_EQ(map.inverse_depth(10, 40), 0.7F);
}

/// Grey of a smooth, textureless scene.
Rgb8 color_at(double x) {
    const auto level = static_cast<std::uint8_t>(std::lround(120 + 100 * std::sin(0.05 * x)));
    return {level, level, level};
}

/// A view and a neighbour to its right. What is continued from column 30 on recedes by `slope_px`.
DepthScene receding_pair(double slope_px) {
    constexpr double kFocalPx = 100;
    constexpr double kBaseline = 1;  // One pixel of disparity is 0.01 of inverse depth.
    constexpr double kStartPx = 30;
    constexpr double kRim = 0.3;
    DepthScene scene;
    for (const int j : {0, 1}) {
        DepthView view;
        view.camera = {kWidth,
                       kHeight,
                       LensModel::kPinhole,
                       {kFocalPx, kFocalPx, kWidth / 2.0, kHeight / 2.0}};
        view.cam_from_world.translation = {-kBaseline * j, 0, 0};
        view.photograph = ColorImage(kWidth, kHeight);
        view.neighbours = {1 - j};
        view.disparity_px_per_inverse_depth = kFocalPx * kBaseline;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const double shift_px = kFocalPx * kBaseline * kRim;
                // x - (shift - slope * (x - start)) is where the neighbour sees column x.
                const double own =
                    j == 0 ? x + 0.5 : (x + 0.5 + shift_px + slope_px * kStartPx) / (1 + slope_px);
                view.photograph(x, y) = color_at(own);
            }
        }
        scene.views.push_back(view);
    }
    return scene;
}

std::vector<double> differences_at(double slope_px) {
    const DepthMap nothing{FloatImage(kWidth, kHeight), GrayImage(kWidth, kHeight)};
    FloatImage distance_px(kWidth, kHeight, 0.0F);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 30; x < kWidth; ++x) distance_px(x, y) = static_cast<float>(x) + 0.5F - 30;
    }
    return recession_differences(receding_pair(slope_px), {nothing, nothing}, 0,
                                 {FloatImage(kWidth, kHeight, 0.3F), GrayImage(kWidth, kHeight)},
                                 distance_px);
}

TEST(RecedingFill, PhotographsDifferLeastAtTheSlopeOfTheScene) {
    for (const auto& [slope_px, expected] : {std::pair{0.0, 0}, {0.3, 1}, {0.6, 2}, {1.0, 3}}) {
        const std::vector<double> differences = differences_at(slope_px);
        ASSERT_EQ(differences.size(), 4U);
        EXPECT_EQ(std::min_element(differences.begin(), differences.end()) - differences.begin(),
                  expected)
            << slope_px;
        const std::vector<std::vector<double>> of_views(4, differences);
        EXPECT_EQ(chosen_recession(of_views), slope_px);
    }
}

TEST(RecedingFill, DoesNotRecedeWhereViewsDisagreeOrAreFew) {
    const std::vector<double> closer{100, 90, 80, 90};
    const std::vector<double> farther{100, 110, 130, 140};
    EXPECT_EQ(chosen_recession({closer, closer, closer, closer}), 0.6);
    EXPECT_EQ(chosen_recession({closer, farther, closer, farther, closer}), 0.0);
    EXPECT_EQ(chosen_recession({closer, closer, closer, {}}), std::nullopt) << "too few to tell";
    EXPECT_EQ(chosen_recession({}), std::nullopt);
}

}  // namespace
}  // namespace lumi
