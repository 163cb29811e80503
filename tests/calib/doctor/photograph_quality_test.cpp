#include "calib/doctor/photograph_quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

/// Detail of equal strength at every scale: a sum of noises, each twice as coarse as the one
/// before.
cv::Mat detail_at_every_scale(int width, int height, unsigned seed) {
    cv::theRNG().state = seed;
    cv::Mat sum = cv::Mat::zeros(height, width, CV_32F);
    for (double sigma = 0.7; sigma < 40; sigma *= 2) {
        cv::Mat noise(height, width, CV_32F);
        cv::randn(noise, 0.0, 1.0);
        cv::GaussianBlur(noise, noise, {}, sigma);
        cv::Scalar mean;
        cv::Scalar deviation;
        cv::meanStdDev(noise, mean, deviation);
        sum += noise * (14.0 / deviation[0]);
    }
    return sum;
}

ColorImage picture_of(const cv::Mat& levels, double middle, double noise_sigma, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, noise_sigma);
    ColorImage picture(levels.cols, levels.rows);
    for (int y = 0; y < levels.rows; ++y) {
        for (int x = 0; x < levels.cols; ++x) {
            const double value = middle + static_cast<double>(levels.at<float>(y, x)) +
                                 (noise_sigma > 0 ? noise(random) : 0.0);
            const auto level = static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
            picture(x, y) = {level, level, level};
        }
    }
    return picture;
}

TEST(PhotographQuality, MeasuresTheNoiseThatWasAdded) {
    const cv::Mat scene = detail_at_every_scale(400, 300, 3);
    cv::Mat smooth;
    cv::GaussianBlur(scene, smooth, {}, 4.0);
    for (const double sigma : {3.0, 8.0, 20.0}) {
        EXPECT_NEAR(quality_of(picture_of(smooth, 128, sigma, 5)).noise_sigma, sigma, 0.15 * sigma)
            << sigma;
    }
}

TEST(PhotographQuality, MeasuresTheBlurThatWasAdded) {
    const cv::Mat scene = detail_at_every_scale(400, 300, 7);
    EXPECT_LT(quality_of(picture_of(scene, 128, 1, 1)).blur_sigma_px, 1.0);
    for (const double sigma_px : {3.0, 6.0}) {
        cv::Mat blurred;
        cv::GaussianBlur(scene, blurred, {}, sigma_px);
        EXPECT_NEAR(quality_of(picture_of(blurred, 128, 1, 1)).blur_sigma_px, sigma_px,
                    0.35 * sigma_px)
            << sigma_px;
    }
}

TEST(PhotographQuality, ContrastFallsInStepWithThePicture) {
    const cv::Mat scene = detail_at_every_scale(400, 300, 9);
    const double full = quality_of(picture_of(scene, 128, 0, 1)).contrast();
    const double tenth = quality_of(picture_of(0.1 * scene, 128, 0, 1)).contrast();
    EXPECT_NEAR(tenth / full, 0.1, 0.02);
}

TEST(PhotographQuality, CountsWhatIsBlackOrWhite) {
    const cv::Mat scene = detail_at_every_scale(200, 150, 11);
    EXPECT_LT(quality_of(picture_of(scene, 128, 0, 1)).clipped_share, 0.01);
    EXPECT_GT(quality_of(picture_of(scene, 330, 0, 1)).clipped_share, 0.9);
    EXPECT_GT(quality_of(picture_of(scene, -80, 0, 1)).clipped_share, 0.9);
}

TEST(PhotographQuality, BrightnessIsWhatTheSensorReceives) {
    // 188 in sRGB is half of full light.
    EXPECT_NEAR(quality_of(ColorImage(64, 64, {188, 188, 188})).mean_linear, 0.5, 0.005);
}

}  // namespace
}  // namespace lumi
