#include "meshing/filling/guided_smoothing.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace lumi {
namespace {

TEST(GuidedSmoothing, OnARowSolvesItsLinearSystem) {
    constexpr int kWidth = 30;
    std::mt19937 random(5);
    ColorImage guide(kWidth, 1);
    FloatImage values(kWidth, 1);
    FloatImage weights(kWidth, 1);
    for (int x = 0; x < kWidth; ++x) {
        guide(x, 0).r = static_cast<std::uint8_t>(random() % 20);
        values(x, 0) = static_cast<float>(random() % 100);
        weights(x, 0) = x % 3 == 0 ? 1.0F : 0.1F;
    }
    const GuidedSmoothing options{.lambda = 40, .sigma = 5, .iterations = 1};
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(kWidth, kWidth);
    for (int x = 0; x + 1 < kWidth; ++x) {
        const double hold =
            1.5 / 3 * 40 * std::exp(-std::abs(guide(x, 0).r - guide(x + 1, 0).r) / 5.0);
        system(x, x) += hold;
        system(x + 1, x + 1) += hold;
        system(x, x + 1) = system(x + 1, x) = -hold;
    }
    Eigen::VectorXd weighted(kWidth);
    Eigen::VectorXd weight(kWidth);
    for (int x = 0; x < kWidth; ++x) {
        weight(x) = static_cast<double>(weights(x, 0));
        weighted(x) = weight(x) * static_cast<double>(values(x, 0));
    }
    const Eigen::VectorXd expected =
        system.ldlt().solve(weighted).cwiseQuotient(system.ldlt().solve(weight));
    const FloatImage smooth = smooth_guided(values, weights, guide, options);
    for (int x = 0; x < kWidth; ++x) EXPECT_NEAR(smooth(x, 0), expected(x), 1e-3) << x;
}

TEST(GuidedSmoothing, StopsAtAnEdgeOfTheGuide) {
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
