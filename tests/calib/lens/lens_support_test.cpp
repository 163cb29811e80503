#include "calib/lens/lens_support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lumi {
namespace {

Eigen::MatrixXd variances(const std::vector<double>& sigmas) {
    const auto count = static_cast<Eigen::Index>(sigmas.size());
    const Eigen::VectorXd sigma = Eigen::Map<const Eigen::VectorXd>(sigmas.data(), count);
    return sigma.cwiseAbs2().asDiagonal();
}

TEST(SupportedLens, KeepsWhatStandsOutOfTwoStandardDeviations) {
    const Camera lens{640, 480, LensModel::kRadial, {500, 330, 236, -0.1, 0.02}};
    const SupportedLens supported =
        supported_lens(lens, all_free(lens.model), variances({1, 1, 1, 0.01, 0.009}));
    EXPECT_EQ(supported.form, all_free(LensModel::kRadial));
    EXPECT_EQ(supported.start, lens);
    EXPECT_TRUE(supported.dropped.empty());
}

TEST(SupportedLens, DropsATermBelowTwoStandardDeviations) {
    const Camera lens{640, 480, LensModel::kRadial, {500, 330, 236, -0.1, 0.02}};
    const SupportedLens supported =
        supported_lens(lens, all_free(lens.model), variances({1, 1, 1, 0.01, 0.011}));
    EXPECT_EQ(supported.form, all_free(LensModel::kSimpleRadial));
    EXPECT_EQ(supported.start.parameters, (std::vector<double>{500, 330, 236, -0.1}));
    ASSERT_EQ(supported.dropped.size(), 1u);
    EXPECT_EQ(supported.dropped[0], "k2 = 0.02 +- 0.011");
}

TEST(SupportedLens, OfTwoTermsThatSayTheSameOneStays) {
    // k1 and k2 are each uncertain by 0.05, but their sum is known to 0.001.
    const Camera lens{640, 480, LensModel::kRadial, {500, 320, 240, -0.06, -0.05}};
    Eigen::MatrixXd covariance = variances({1, 0, 0, 0.05, 0.05});
    covariance(3, 4) = covariance(4, 3) = 0.5 * (0.001 * 0.001 - 2 * 0.05 * 0.05);
    const SupportedLens supported =
        supported_lens(lens, with_principal_point_held(lens.model), covariance);
    EXPECT_EQ(supported.form, with_principal_point_held(LensModel::kSimpleRadial));
    EXPECT_NEAR(supported.start.parameters[3], -0.11, 1e-3);
}

TEST(SupportedLens, APrincipalPointGoesToTheMiddleAsAWhole) {
    const Camera lens{640, 480, LensModel::kSimpleRadial, {500, 321, 241, -0.1}};
    const SupportedLens both =
        supported_lens(lens, all_free(lens.model), variances({1, 1, 1, 0.001}));
    EXPECT_EQ(both.form, with_principal_point_held(LensModel::kSimpleRadial));
    EXPECT_EQ(both.start.parameters[1], 320);
    EXPECT_EQ(both.start.parameters[2], 240);
    const SupportedLens neither =
        supported_lens(lens, all_free(lens.model), variances({1, 0.3, 1, 0.001}));
    EXPECT_EQ(neither.form, all_free(LensModel::kSimpleRadial));
}

TEST(SupportedLens, SquarePixelsNeedOneFocalLength) {
    const Camera lens{640, 480, LensModel::kOpenCv, {500, 501, 330, 236, -0.1, 0.001, 0, 0}};
    const Eigen::MatrixXd covariance = variances({1, 1, 1, 1, 0.01, 0.01, 0.001, 0.001});
    const SupportedLens supported = supported_lens(lens, all_free(lens.model), covariance);
    EXPECT_EQ(supported.form, all_free(LensModel::kSimpleRadial));
    EXPECT_NEAR(supported.start.parameters[0], 500.5, 1e-9);

    Camera oblong = lens;
    oblong.parameters[1] = 520;
    const SupportedLens kept = supported_lens(oblong, all_free(lens.model), covariance);
    // SIMPLE_RADIAL has one focal length: OPENCV stays, with what it lacks support for held at 0.
    EXPECT_EQ(kept.form, (LensForm{LensModel::kOpenCv, {5, 6, 7}}));
}

TEST(SupportedLens, WhatWentStaysGoneWhateverItIsCorrelatedWith) {
    constexpr int kParameters = 8;
    const Camera lens{640, 480, LensModel::kOpenCv, {500, 500, 320, 240, -0.1, 3e-4, 2e-4, -1e-4}};
    const std::vector<double> sigmas{1, 1, 1, 1, 0.01, 1e-3, 1e-3, 1e-3};
    Eigen::MatrixXd covariance = variances(sigmas);
    for (int row = 0; row < kParameters; ++row) {
        for (int column = 0; column < row; ++column) {
            const double correlation = 0.7 / (1 + 0.37 * (row - column));
            covariance(row, column) = covariance(column, row) =
                correlation * std::sqrt(covariance(row, row) * covariance(column, column));
        }
    }
    const SupportedLens supported =
        supported_lens(lens, with_principal_point_held(lens.model), covariance);
    EXPECT_EQ(supported.dropped.size(), 4u);
    EXPECT_EQ(supported.form, with_principal_point_held(LensModel::kSimpleRadial));
}

TEST(SupportedLens, AllOfAHeldLensStays) {
    const Camera lens{640, 480, LensModel::kRadial, {500, 330, 236, -0.1, 0.02}};
    const SupportedLens supported =
        supported_lens(lens, all_held(lens.model), Eigen::MatrixXd::Zero(5, 5));
    EXPECT_EQ(supported.form, all_held(LensModel::kRadial));
    EXPECT_EQ(supported.start, lens);
}

TEST(SupportedLens, AFisheyeStaysOne) {
    const Camera lens{640, 480, LensModel::kOpenCvFisheye, {300, 300, 320, 240, 0.1, 0, 0, 0}};
    const SupportedLens supported = supported_lens(lens, with_principal_point_held(lens.model),
                                                   variances({1, 1, 0, 0, 0.01, 0.01, 0.01, 0.01}));
    EXPECT_EQ(supported.form.model, LensModel::kOpenCvFisheye);
    EXPECT_EQ(supported.form.held, (std::vector<int>{2, 3, 5, 6, 7}));
}

}  // namespace
}  // namespace lumi
