#include "calib/adjust/reprojection_cost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "calib/adjust/camera_blocks.h"
#include "calib/capture/lens_distortion.h"
#include "calib/capture/rigid3.h"

namespace lumi {
namespace {

struct LensCase {
    LensModel model;
    std::vector<double> parameters;
};

/// The same residual for Ceres to differentiate by itself.
template <LensModel model>
struct AutomaticCost {
    Eigen::Vector2d seen_at;

    template <class T>
    bool operator()(const T* lens, const T* pose, const T* point, T* residual) const {
        using Vector3 = Eigen::Matrix<T, 3, 1>;
        const Vector3 point_in_cam =
            Eigen::Map<const Eigen::Quaternion<T>>(pose) * Eigen::Map<const Vector3>(point) +
            Eigen::Map<const Vector3>(pose + 4);
        const Eigen::Matrix<T, 2, 1> at_depth_one =
            point_in_cam.template head<2>() / point_in_cam.z();
        const Eigen::Matrix<T, 2, 1> pixel = pixel_of<model>(lens, at_depth_one);
        residual[0] = pixel.x() - seen_at.x();
        residual[1] = pixel.y() - seen_at.y();
        return true;
    }
};

template <LensModel model>
std::unique_ptr<ceres::CostFunction> automatic(const Eigen::Vector2d& seen_at) {
    return std::make_unique<ceres::AutoDiffCostFunction<
        AutomaticCost<model>, 2, static_cast<int>(parameter_count(model)), 7, 3>>(
        new AutomaticCost<model>{seen_at});
}

std::unique_ptr<ceres::CostFunction> automatic_cost(LensModel model,
                                                    const Eigen::Vector2d& seen_at) {
    return with_lens_model(model, [&](auto known) -> std::unique_ptr<ceres::CostFunction> {
        return automatic<known>(seen_at);
    });
}

class ReprojectionCostOf : public testing::TestWithParam<LensCase> {
 protected:
    const Rigid3 pose_{Eigen::Quaterniond(0.9, 0.1, -0.3, 0.2).normalized(), {0.2, -0.1, 3.0}};
    const PoseBlock pose_block_ = pose_block(pose_);
    const Eigen::Vector3d point_{0.5, 0.4, -0.3};
    const Eigen::Vector2d seen_at_{300.0, 200.0};
};

TEST_P(ReprojectionCostOf, EqualsTheProjectionStatedInPlainCode) {
    const Camera camera{640, 480, GetParam().model, GetParam().parameters};
    const auto expected = project(camera, pose_ * point_);
    ASSERT_TRUE(expected.has_value());
    const auto cost = reprojection_cost(camera.model, seen_at_);
    const std::array<const double*, 3> blocks{camera.parameters.data(), pose_block_.data(),
                                              point_.data()};
    Eigen::Vector2d residual;
    ASSERT_TRUE(cost->Evaluate(blocks.data(), residual.data(), nullptr));
    EXPECT_LT((residual + seen_at_ - *expected).norm(), 1e-9);
}

TEST_P(ReprojectionCostOf, DerivativesEqualAutomaticOnes) {
    const LensCase& lens = GetParam();
    const std::array<const double*, 3> blocks{lens.parameters.data(), pose_block_.data(),
                                              point_.data()};
    const auto derivatives = [&](const ceres::CostFunction& cost) {
        std::array<std::array<double, 24>, 3> values{};
        std::array<double*, 3> pointers{values[0].data(), values[1].data(), values[2].data()};
        Eigen::Vector2d residual;
        EXPECT_TRUE(cost.Evaluate(blocks.data(), residual.data(), pointers.data()));
        return values;
    };
    const auto written_out = derivatives(*reprojection_cost(lens.model, seen_at_));
    const auto expected = derivatives(*automatic_cost(lens.model, seen_at_));
    for (std::size_t block = 0; block < expected.size(); ++block) {
        for (std::size_t index = 0; index < expected[block].size(); ++index) {
            EXPECT_NEAR(written_out[block][index], expected[block][index],
                        1e-10 * std::max(1.0, std::abs(expected[block][index])))
                << "block " << block << " index " << index;
        }
    }
}

TEST_P(ReprojectionCostOf, DerivativesEqualDifferenceQuotients) {
    const auto cost = reprojection_cost(GetParam().model, seen_at_);
    std::vector<double> lens = GetParam().parameters;
    PoseBlock pose = pose_block_;
    std::array<double, 3> point{point_.x(), point_.y(), point_.z()};
    const std::array<double*, 3> blocks{lens.data(), pose.data(), point.data()};
    std::array<std::array<double, 24>, 3> jacobians{};
    std::array<double*, 3> jacobian_pointers{jacobians[0].data(), jacobians[1].data(),
                                             jacobians[2].data()};
    Eigen::Vector2d residual;
    ASSERT_TRUE(cost->Evaluate(blocks.data(), residual.data(), jacobian_pointers.data()));
    const std::array<std::size_t, 3> sizes{lens.size(), 7, 3};
    for (std::size_t block = 0; block < sizes.size(); ++block) {
        for (std::size_t column = 0; column < sizes[block]; ++column) {
            double& value = blocks[block][column];
            const double kept = value;
            const double step = 1e-6 * std::max(1.0, std::abs(kept));
            Eigen::Vector2d above;
            Eigen::Vector2d below;
            value = kept + step;
            ASSERT_TRUE(cost->Evaluate(blocks.data(), above.data(), nullptr));
            value = kept - step;
            ASSERT_TRUE(cost->Evaluate(blocks.data(), below.data(), nullptr));
            value = kept;
            for (std::size_t row = 0; row < 2; ++row) {
                const double quotient =
                    (above - below)[static_cast<Eigen::Index>(row)] / (2 * step);
                EXPECT_NEAR(jacobians[block][row * sizes[block] + column], quotient,
                            1e-5 * std::max(1.0, std::abs(quotient)))
                    << "block " << block << " row " << row << " column " << column;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    EveryLens, ReprojectionCostOf,
    testing::Values(
        LensCase{LensModel::kSimplePinhole, {500, 320, 240}},
        LensCase{LensModel::kPinhole, {500, 510, 320, 240}},
        LensCase{LensModel::kSimpleRadial, {500, 320, 240, -0.1}},
        LensCase{LensModel::kRadial, {500, 320, 240, -0.1, 0.03}},
        LensCase{LensModel::kOpenCv, {500, 510, 320, 240, -0.1, 0.03, 0.01, -0.02}},
        LensCase{LensModel::kOpenCvFisheye, {500, 510, 320, 240, 0.02, -0.01, 0.003, -0.001}},
        LensCase{LensModel::kFullOpenCv,
                 {500, 510, 320, 240, -0.1, 0.03, 0.01, -0.02, 0.005, 0.02, 0.01, 0.002}}),
    [](const auto& instance) { return std::string(name_of(instance.param.model)); });

TEST(ReprojectionCost, HasNoValueBehindTheCamera) {
    const Camera camera = pinhole_camera(640, 480, 500);
    const auto cost = reprojection_cost(camera.model, {300, 200});
    const PoseBlock pose = pose_block({});
    const std::array<double, 3> point{0, 0, -1};
    const std::array<const double*, 3> blocks{camera.parameters.data(), pose.data(), point.data()};
    Eigen::Vector2d residual;
    EXPECT_FALSE(cost->Evaluate(blocks.data(), residual.data(), nullptr));
}

TEST(ReprojectionCost, FisheyeHasADerivativeOnTheOpticalAxis) {
    const std::vector<double> lens{500, 500, 320, 240, 0.1, 0, 0, 0};
    const auto cost = reprojection_cost(LensModel::kOpenCvFisheye, {320, 240});
    const PoseBlock pose = pose_block({});
    const std::array<double, 3> point{0, 0, 1};
    const std::array<const double*, 3> blocks{lens.data(), pose.data(), point.data()};
    std::array<double, 6> by_point{};
    std::array<double*, 3> jacobians{nullptr, nullptr, by_point.data()};
    Eigen::Vector2d residual;
    ASSERT_TRUE(cost->Evaluate(blocks.data(), residual.data(), jacobians.data()));
    EXPECT_NEAR(by_point[0], 500, 1e-9);
    EXPECT_NEAR(by_point[4], 500, 1e-9);
}

}  // namespace
}  // namespace lumi
