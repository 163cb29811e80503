#include "calib/features/sift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace lumi {
namespace {

/// A dark picture with round bright spots, whose middles are exact in our pixels.
GrayImage spots(const std::vector<Eigen::Vector2d>& middles, double sigma_px) {
    GrayImage image(200, 160);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            double value = 20;
            for (const Eigen::Vector2d& middle : middles) {
                const double r2 = (Eigen::Vector2d(x + 0.5, y + 0.5) - middle).squaredNorm();
                value += 200 * std::exp(-r2 / (2 * sigma_px * sigma_px));
            }
            image(x, y) = static_cast<std::uint8_t>(std::lround(std::min(value, 255.0)));
        }
    }
    return image;
}

double nearest_distance_px(const Features& features, const Eigen::Vector2d& place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Keypoint& keypoint : features.keypoints) {
        nearest = std::min(nearest, (keypoint.pixel.cast<double>() - place).norm());
    }
    return nearest;
}

TEST(Sift, PlacesFeaturesInOurPixelConvention) {
    const std::vector<Eigen::Vector2d> middles{{50.0, 60.0}, {120.3, 40.7}, {150.5, 110.25}};
    // Half a pixel of OpenCV's convention or a quarter of its doubled picture would show.
    for (const double sigma_px : {2.5, 4.0}) {
        const Features features = detect_sift(spots(middles, sigma_px), {});
        for (const Eigen::Vector2d& middle : middles) {
            EXPECT_LT(nearest_distance_px(features, middle), 0.1)
                << "spot at " << middle.transpose() << " of " << sigma_px << " px";
        }
    }
}

TEST(Sift, ScalesGrowWithTheSpotsAndComeLargestFirst) {
    const Features small = detect_sift(spots({{100, 80}}, 2.5), {});
    const Features large = detect_sift(spots({{100, 80}}, 5.0), {});
    ASSERT_GT(small.size(), 0u);
    ASSERT_GT(large.size(), 0u);
    EXPECT_GT(large.keypoints[0].scale_px, 1.5F * small.keypoints[0].scale_px);
    EXPECT_TRUE(std::is_sorted(
        large.keypoints.begin(), large.keypoints.end(),
        [](const Keypoint& a, const Keypoint& b) { return a.scale_px > b.scale_px; }));
}

TEST(Sift, DescriptorsAreOfUnitLengthTimes512) {
    const Features features = detect_sift(spots({{60, 60}, {70, 66}, {120, 90}}, 3), {});
    ASSERT_GT(features.size(), 0u);
    for (const Descriptor& descriptor : features.descriptors) {
        const double squared = std::transform_reduce(
            descriptor.begin(), descriptor.end(), 0.0, std::plus<>(),
            [](std::int16_t value) { return static_cast<double>(value) * value; });
        EXPECT_NEAR(std::sqrt(squared), 512.0, 16.0);  // Rounded, and cut at 255.
    }
}

TEST(Sift, FindsNothingInAnEvenPicture) {
    EXPECT_EQ(detect_sift(GrayImage(100, 80, 128), {}).size(), 0u);
    EXPECT_EQ(detect_sift(GrayImage(), {}).size(), 0u);
}

TEST(Sift, KeepsAtMostMaxFeatures) {
    std::vector<Eigen::Vector2d> middles;
    for (int y = 20; y < 150; y += 20) {
        for (int x = 20; x < 190; x += 20) middles.emplace_back(x, y);
    }
    const GrayImage picture = spots(middles, 2.5);
    ASSERT_GT(detect_sift(picture, {}).size(), 30u);
    EXPECT_EQ(detect_sift(picture, {.max_features = 30}).size(), 30u);
}

TEST(Sift, WhatAMaskHidesIsNeitherFoundNorCounted) {
    std::vector<Eigen::Vector2d> middles;
    for (int y = 20; y < 150; y += 20) {
        for (int x = 20; x < 190; x += 20) middles.emplace_back(x, y);
    }
    const GrayImage picture = spots(middles, 2.5);
    GrayImage mask(picture.width(), picture.height(), 0);
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 110; ++x) mask(x, y) = 255;
    }
    const Features seen = detect_sift(picture, {.max_features = 8}, mask);
    EXPECT_EQ(seen.size(), 8u);
    for (const Keypoint& keypoint : seen.keypoints) {
        EXPECT_LT(keypoint.pixel.x(), 110.0F);
        EXPECT_LT(keypoint.pixel.y(), 60.0F);
    }
    EXPECT_LT(nearest_distance_px(detect_sift(picture, {}, mask), {40.0, 40.0}), 0.1);
    const GrayImage nothing(picture.width(), picture.height(), 0);
    EXPECT_EQ(detect_sift(picture, {}, nothing).size(), 0u);
}

}  // namespace
}  // namespace lumi
