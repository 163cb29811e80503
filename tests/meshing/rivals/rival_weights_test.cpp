#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "meshing/rivals/heigl_weights.h"
#include "meshing/rivals/unstructured_weights.h"
#include "meshing/rivals/view_dependent_weights.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

Points grid() {
    Points centres;
    for (int i = 0; i < 16; ++i) centres.emplace_back(i % 4, i / 4 + 0.01 * (i % 3), 0.0);
    return centres;
}

double sum_of(const std::vector<double>& weights) {
    return std::accumulate(weights.begin(), weights.end(), 0.0);
}

TEST(HeiglFrame, BlendsAPixelFromTheTriangleOfProjectedCamerasAroundIt) {
    const Points centres = grid();
    const Points axes(centres.size(), Eigen::Vector3d::UnitZ());
    // An eye behind the cameras that looks the way they do: the picture plane at the cameras is
    // their plane, and weights are their plane's barycentric coordinates.
    const Rigid3 eye_from_world{Eigen::Quaterniond::Identity(), -Eigen::Vector3d(1.4, 1.6, -3)};
    const HeiglFrame frame(centres, axes, eye_from_world);
    const Eigen::Vector3d on_grid(1.3, 1.2, 0);
    const Eigen::Vector3d eye(1.4, 1.6, -3);
    const auto weights = frame.weights_towards(eye + 3 * (on_grid - eye));
    EXPECT_NEAR(sum_of(weights), 1, 1e-12);
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    int cameras = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        place += weights[i] * centres[i];
        cameras += weights[i] > 0 ? 1 : 0;
    }
    EXPECT_LE(cameras, 3);
    EXPECT_LT((place - on_grid).norm(), 1e-12);
    // Beyond all cameras there is no triangle.
    EXPECT_EQ(sum_of(frame.weights_towards(eye + Eigen::Vector3d(50, 0, 3))), 0);
}

TEST(UnstructuredWeights, AreOneAtACameraAndDependOnWhereOnTheRayTheEyeStands) {
    const Points centres = grid();
    const Eigen::Vector3d target(1.7, 1.1, 8);
    const auto at_camera = unstructured_weights(centres, centres[5], target);
    EXPECT_GT(at_camera[5], 0.99 * sum_of(at_camera) / 2);
    const Eigen::Vector3d eye(1.35, 1.2, -1);
    const auto one = unstructured_weights(centres, eye, target);
    const auto other = unstructured_weights(centres, target + 0.3 * (eye - target), target);
    EXPECT_NEAR(sum_of(one), 1, 1e-12);
    double difference = 0;
    for (std::size_t i = 0; i < one.size(); ++i) difference += std::abs(one[i] - other[i]);
    EXPECT_GT(difference, 1e-3);
}

TEST(ViewDependentWeights, AreOfTheThreeNearestDirectionsByOneOverTheAngle) {
    // On a circle about the polygon's middle, at angles of 1, 2, 4 and 8 hundredths from the eye.
    const Eigen::Vector3d middle(0.3, -0.2, 1);
    const auto at = [&](double angle, double distance) {
        return (middle + distance * Eigen::Vector3d(std::sin(angle), 0, std::cos(angle))).eval();
    };
    const Points centres{at(0.04, 3), at(-0.01, 2), at(0.08, 1), at(0.02, 5)};
    const auto weights = view_dependent_weights(centres, at(0, 2.5), middle);
    // 1/4 : 1 : 1/2, of which the sum is 7/4.
    EXPECT_NEAR(weights[0], 1.0 / 7, 1e-12);
    EXPECT_NEAR(weights[1], 4.0 / 7, 1e-12);
    EXPECT_EQ(weights[2], 0);
    EXPECT_NEAR(weights[3], 2.0 / 7, 1e-12);
}

TEST(ViewDependentWeights, OfOneCameraAreOne) {
    EXPECT_EQ(view_dependent_weights({{1, 2, 3}}, {0, 0, 1}, {0, 0, 0}), std::vector<double>{1.0});
}

TEST(UnstructuredWeights, OfFewCamerasAreThoseOfTheNearest) {
    const auto weights = unstructured_weights({{0, 0, 0}, {1, 0, 0}}, {0.1, 0, -1}, {0, 0, 5});
    EXPECT_EQ(weights[0], 1);
}

}  // namespace
}  // namespace lumi
