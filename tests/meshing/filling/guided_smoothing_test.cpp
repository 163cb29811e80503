#include "meshing/filling/guided_smoothing.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdlib>
#include <random>
#include <utility>

namespace lumi {
namespace {

/// Random pictures to smooth, and the guide to do it along.
struct Smoothed {
    FloatImage values;
    FloatImage weights;
    ColorImage guide;
};

Smoothed random_pictures(int width, int height) {
    std::mt19937 random(5);
    Smoothed made{FloatImage(width, height), FloatImage(width, height), ColorImage(width, height)};
    for (std::size_t i = 0; i < made.values.pixels().size(); ++i) {
        made.guide.pixels()[i].r = static_cast<std::uint8_t>(random() % 20);
        made.values.pixels()[i] = static_cast<float>(random() % 100);
        made.weights.pixels()[i] = i % 3 == 0 ? 1.0F : 0.1F;
    }
    return made;
}

/// I + strength * the guide's Laplacian along the rows or columns, of all pixels.
Eigen::MatrixXd system_of(const ColorImage& guide, bool along_rows, double strength, double sigma) {
    const int width = guide.width();
    const int count = width * guide.height();
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(count, count);
    for (int y = 0; y < guide.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            const int next_x = along_rows ? x + 1 : x;
            const int next_y = along_rows ? y : y + 1;
            if (!guide.contains(next_x, next_y)) continue;
            const int difference = std::abs(guide(x, y).r - guide(next_x, next_y).r);
            const double hold = strength * std::exp(-difference / sigma);
            const int i = y * width + x;
            const int next = next_y * width + next_x;
            system(i, i) += hold;
            system(next, next) += hold;
            system(i, next) = system(next, i) = -hold;
        }
    }
    return system;
}

/// Rows and columns in turn, with strengths that fall to a quarter each time.
Eigen::VectorXd smoothed_by_dense_solutions(const Smoothed& given, const GuidedSmoothing& options) {
    const auto count = static_cast<Eigen::Index>(given.values.pixels().size());
    Eigen::VectorXd weighted(count);
    Eigen::VectorXd weight(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        weight(i) = static_cast<double>(given.weights.pixels()[k]);
        weighted(i) = weight(i) * static_cast<double>(given.values.pixels()[k]);
    }
    for (int t = 1; t <= options.iterations; ++t) {
        const double strength = 1.5 * std::pow(4.0, options.iterations - t) /
                                (std::pow(4.0, options.iterations) - 1) * options.lambda;
        for (const bool along_rows : {true, false}) {
            const auto system = system_of(given.guide, along_rows, strength, options.sigma).ldlt();
            weighted = system.solve(weighted).eval();
            weight = system.solve(weight).eval();
        }
    }
    return weighted.cwiseQuotient(weight);
}

void expect_dense_solutions(int width, int height, int iterations) {
    const Smoothed given = random_pictures(width, height);
    const GuidedSmoothing options{.lambda = 40, .sigma = 5, .iterations = iterations};
    const Eigen::VectorXd expected = smoothed_by_dense_solutions(given, options);
    const FloatImage smooth = smooth_guided(given.values, given.weights, given.guide, options);
    for (Eigen::Index i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(smooth.pixels()[static_cast<std::size_t>(i)], expected(i), 1e-3) << i;
    }
}

TEST(GuidedSmoothing, OnARowSolvesItsLinearSystem) { expect_dense_solutions(30, 1, 1); }

TEST(GuidedSmoothing, OnAColumnSolvesItsLinearSystem) { expect_dense_solutions(1, 30, 1); }

TEST(GuidedSmoothing, SolvesTheSystemsOfRowsAndColumnsInTurn) {
    expect_dense_solutions(9, 7, 3);
    expect_dense_solutions(5, 20, 2);  // Of more rows than are solved side by side.
}

/// Mean and variance of the columns from `left` on to `right`.
std::pair<double, double> mean_and_variance(const FloatImage& values, int left, int right) {
    double sum = 0;
    double squares = 0;
    for (int y = 0; y < values.height(); ++y) {
        for (int x = left; x < right; ++x) {
            const auto value = static_cast<double>(values(x, y));
            sum += value;
            squares += value * value;
        }
    }
    const double count = (right - left) * values.height();
    return {sum / count, squares / count - sum * sum / (count * count)};
}

TEST(GuidedSmoothing, StopsAtAnEdgeOfTheGuideAndSmoothsBesideIt) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> noise(-0.5F, 0.5F);
    ColorImage guide(40, 20, {50, 50, 50});
    FloatImage values(40, 20);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 40; ++x) {
            if (x >= 20) guide(x, y) = {50, 150, 50};
            values(x, y) = (x < 20 ? 1.0F : 3.0F) + noise(random);
        }
    }
    const FloatImage smooth = smooth_guided(values, FloatImage(40, 20, 1.0F), guide, {});
    for (const int left : {0, 20}) {
        const auto [mean_before, variance_before] = mean_and_variance(values, left, left + 20);
        const auto [mean, variance] = mean_and_variance(smooth, left, left + 20);
        EXPECT_NEAR(mean, mean_before, 1e-4);
        EXPECT_LT(variance, 0.1 * variance_before);
    }
}

TEST(GuidedSmoothing, LeavesWhatIsEvenOnEitherSideOfAnEdge) {
    ColorImage guide(40, 20, {50, 50, 50});
    FloatImage values(40, 20, 1.0F);
    for (int y = 0; y < 20; ++y) {
        for (int x = 20; x < 40; ++x) {
            guide(x, y) = {50, 150, 50};
            values(x, y) = 3.0F;
        }
    }
    const FloatImage smooth = smooth_guided(values, FloatImage(40, 20, 1.0F), guide, {});
    for (std::size_t i = 0; i < values.pixels().size(); ++i) {
        ASSERT_NEAR(smooth.pixels()[i], values.pixels()[i], 1e-4F) << i;
    }
}

}  // namespace
}  // namespace lumi
