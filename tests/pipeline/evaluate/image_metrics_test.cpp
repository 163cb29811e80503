#include "pipeline/evaluate/image_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/quality/qualitymse.hpp>
#include <opencv2/quality/qualityssim.hpp>
#include <random>

#include "calib/work/error.h"

namespace lumi {
namespace {

ColorImage noise(int width, int height, std::uint32_t seed) {
    std::mt19937 random(seed);
    ColorImage image(width, height);
    for (Rgb8& pixel : image.pixels()) {
        const auto bits = static_cast<std::uint32_t>(random());
        pixel = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U),
                 static_cast<std::uint8_t>(bits >> 16U)};
    }
    return image;
}

ColorImage uniform(int width, int height, std::uint8_t grey) {
    return {width, height, {grey, grey, grey}};
}

/// Wang et al. 2004 to the letter: an explicit 11 x 11 window at every place, centred moments.
double structural_similarity_by_windows(const ColorImage& a, const ColorImage& b) {
    const Image<double> x = luma(a);
    const Image<double> y = luma(b);
    double window[11][11];
    double window_sum = 0.0;
    for (int v = 0; v < 11; ++v) {
        for (int u = 0; u < 11; ++u) {
            window[v][u] = std::exp(-((u - 5) * (u - 5) + (v - 5) * (v - 5)) / (2 * 1.5 * 1.5));
            window_sum += window[v][u];
        }
    }
    double sum = 0.0;
    int count = 0;
    for (int top = 0; top + 11 <= x.height(); ++top) {
        for (int left = 0; left + 11 <= x.width(); ++left) {
            double mean_x = 0.0;
            double mean_y = 0.0;
            for (int v = 0; v < 11; ++v) {
                for (int u = 0; u < 11; ++u) {
                    mean_x += window[v][u] / window_sum * x(left + u, top + v);
                    mean_y += window[v][u] / window_sum * y(left + u, top + v);
                }
            }
            double xx = 0.0;
            double yy = 0.0;
            double xy = 0.0;
            for (int v = 0; v < 11; ++v) {
                for (int u = 0; u < 11; ++u) {
                    const double dx = x(left + u, top + v) - mean_x;
                    const double dy = y(left + u, top + v) - mean_y;
                    xx += window[v][u] / window_sum * dx * dx;
                    yy += window[v][u] / window_sum * dy * dy;
                    xy += window[v][u] / window_sum * dx * dy;
                }
            }
            const double c1 = 6.5025;   // (0.01 * 255)^2
            const double c2 = 58.5225;  // (0.03 * 255)^2
            sum += (2 * mean_x * mean_y + c1) * (2 * xy + c2) /
                   ((mean_x * mean_x + mean_y * mean_y + c1) * (xx + yy + c2));
            ++count;
        }
    }
    return sum / count;
}

TEST(ImageMetrics, PsnrOfAUniformDifferenceHasAClosedForm) {
    for (const int difference : {1, 2, 16, 255}) {
        const double expected_db = 20.0 * std::log10(255.0 / difference);
        EXPECT_NEAR(psnr_db(uniform(9, 7, 0), uniform(9, 7, static_cast<std::uint8_t>(difference))),
                    expected_db, 1e-12)
            << "difference " << difference;
    }
}

TEST(ImageMetrics, PsnrWeighsChannelsAlike) {
    const ColorImage black(5, 5, {0, 0, 0});
    // One channel of three differs by 30: mean square 300.
    const double expected_db = 10.0 * std::log10(255.0 * 255.0 / 300.0);
    EXPECT_NEAR(psnr_db(black, ColorImage(5, 5, {30, 0, 0})), expected_db, 1e-12);
    EXPECT_NEAR(psnr_db(black, ColorImage(5, 5, {0, 30, 0})), expected_db, 1e-12);
    EXPECT_NEAR(psnr_db(black, ColorImage(5, 5, {0, 0, 30})), expected_db, 1e-12);
}

TEST(ImageMetrics, EqualPicturesAreIdentical) {
    const ColorImage image = noise(40, 30, 1);
    EXPECT_EQ(psnr_db(image, image), kIdenticalPsnrDb);
    EXPECT_NEAR(structural_similarity(image, image), 1.0, 1e-12);
}

TEST(ImageMetrics, CoveredPsnrLooksAtCoveredPixelsAlone) {
    ColorImage rendering = uniform(10, 10, 100);
    GrayImage coverage(10, 10, 255);
    for (int x = 0; x < 10; ++x) {
        rendering(x, 0) = {0, 0, 0};
        coverage(x, 0) = 0;
    }
    const ColorImage photograph = uniform(10, 10, 110);
    const std::optional<double> covered_db = psnr_db(photograph, rendering, coverage);
    ASSERT_TRUE(covered_db.has_value());
    EXPECT_NEAR(*covered_db, 20.0 * std::log10(255.0 / 10.0), 1e-12);
    EXPECT_LT(psnr_db(photograph, rendering), *covered_db);
    EXPECT_NEAR(covered_share(coverage), 0.9, 1e-12);
}

TEST(ImageMetrics, NothingCoveredHasNoCoveredPsnr) {
    EXPECT_FALSE(psnr_db(uniform(3, 3, 1), uniform(3, 3, 2), GrayImage(3, 3, 0)).has_value());
    EXPECT_EQ(covered_share(GrayImage(3, 3, 0)), 0.0);
}

TEST(ImageMetrics, SimilarityOfUniformPicturesHasAClosedForm) {
    const double c1 = 6.5025;
    EXPECT_NEAR(structural_similarity(uniform(20, 15, 40), uniform(20, 15, 200)),
                (2 * 40.0 * 200.0 + c1) / (40.0 * 40.0 + 200.0 * 200.0 + c1), 1e-9);
}

TEST(ImageMetrics, SimilarityEqualsItsDefinitionWindowByWindow) {
    const ColorImage a = noise(37, 23, 2);
    ColorImage b = noise(37, 23, 3);
    for (std::size_t i = 0; i < b.pixels().size(); i += 2) b.pixels()[i] = a.pixels()[i];
    const double similarity = structural_similarity(a, b);
    EXPECT_NEAR(similarity, structural_similarity_by_windows(a, b), 1e-9);
    EXPECT_GT(similarity, 0.1);
    EXPECT_LT(similarity, 0.9);
}

cv::Mat matrix_of(const ColorImage& image) {
    cv::Mat matrix(image.height(), image.width(), CV_8UC3);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Rgb8& pixel = image(x, y);
            matrix.at<cv::Vec3b>(y, x) = {pixel.b, pixel.g, pixel.r};
        }
    }
    return matrix;
}

/// Noise of neighbouring pixels averaged, so that it has structure; grey where `grey`.
ColorImage structured(int width, int height, std::uint32_t seed, bool grey) {
    const ColorImage fine = noise(width + 3, height + 3, seed);
    ColorImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            int sum = 0;
            for (int v = 0; v < 4; ++v) {
                for (int u = 0; u < 4; ++u) sum += fine(x + u, y + v).g;
            }
            const auto value = static_cast<std::uint8_t>(sum / 16);
            image(x, y) = grey ? Rgb8{value, value, value} : Rgb8{value, fine(x, y).r, 90};
        }
    }
    return image;
}

TEST(ImageMetrics, PsnrEqualsThatOfOpenCvsQualityModule) {
    const ColorImage a = structured(120, 80, 1, false);
    ColorImage b = structured(120, 80, 1, false);
    for (std::size_t i = 0; i < b.pixels().size(); i += 3) b.pixels()[i].g ^= 9U;
    // OpenCV averages over channels what each has; the mean square over all is the same thing.
    const cv::Scalar mean_square =
        cv::quality::QualityMSE::compute(matrix_of(a), matrix_of(b), cv::noArray());
    const double expected_db =
        10.0 * std::log10(255.0 * 255.0 * 3.0 / (mean_square[0] + mean_square[1] + mean_square[2]));
    EXPECT_NEAR(psnr_db(a, b), expected_db, 1e-6);
    EXPECT_NEAR(psnr_db(a, b), cv::PSNR(matrix_of(a), matrix_of(b)), 1e-6);
}

TEST(ImageMetrics, SimilarityEqualsThatOfOpenCvsQualityModuleWithinTheFrame) {
    // As scikit-image does with gaussian_weights, sigma 1.5 and use_sample_covariance off, windows
    // that leave the picture do not count; OpenCV mirrors the picture for them.
    const ColorImage a = structured(120, 80, 1, true);
    ColorImage b = structured(120, 80, 1, true);
    for (int y = 20; y < 50; ++y) {
        for (int x = 30; x < 90; ++x) {
            const auto value = static_cast<std::uint8_t>((b(x, y).g + 60 + x) / 2);
            b(x, y) = {value, value, value};
        }
    }
    cv::Mat map;
    cv::quality::QualitySSIM::compute(matrix_of(a), matrix_of(b), map);
    const cv::Scalar inside = cv::mean(map(cv::Rect(5, 5, 110, 70)));
    EXPECT_NEAR(structural_similarity(a, b), inside[0], 1e-4);  // OpenCV's map is 32-bit.
    EXPECT_LT(inside[0], 0.97);
}

TEST(ImageMetrics, RefusesPicturesOfDifferentSize) {
    EXPECT_THROW(static_cast<void>(psnr_db(uniform(4, 4, 0), uniform(4, 5, 0))), Error);
    EXPECT_THROW(static_cast<void>(structural_similarity(uniform(12, 10, 0), uniform(12, 10, 0))),
                 Error);
}

}  // namespace
}  // namespace lumi
