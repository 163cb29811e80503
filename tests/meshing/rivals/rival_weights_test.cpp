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

TEST(HeiglFrame, TakesACameraBehindTheEyeForTheLineThroughBoth) {
    const Eigen::Vector3d eye(1.4, 1.6, -3);
    const Rigid3 eye_from_world{Eigen::Quaterniond::Identity(), -eye};
    const Points centres = grid();
    const Points axes(centres.size(), Eigen::Vector3d::UnitZ());
    Points mirrored = centres;
    for (std::size_t i = 0; i < mirrored.size(); i += 2)
        mirrored[i] = eye - 0.4 * (centres[i] - eye);
    const Eigen::Vector3d target(1.3, 1.2, 0);
    const auto before = HeiglFrame(centres, axes, eye_from_world).weights_towards(target);
    const auto behind = HeiglFrame(mirrored, axes, eye_from_world).weights_towards(target);
    EXPECT_NEAR(sum_of(behind), 1, 1e-12);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(behind[i], before[i], 1e-9) << i;
}

TEST(HeiglFrame, HearsNoCameraThatLooksMoreThan45DegreesAside) {
    const Eigen::Vector3d eye(1.4, 1.6, -3);
    const Rigid3 eye_from_world{Eigen::Quaterniond::Identity(), -eye};
    const Points centres = grid();
    const auto weight_of_aside = [&](double angle) {
        Points axes(centres.size(), Eigen::Vector3d::UnitZ());
        axes[5] = {std::sin(angle), 0, std::cos(angle)};
        return HeiglFrame(centres, axes, eye_from_world).weights_towards(centres[5])[5];
    };
    EXPECT_NEAR(weight_of_aside(0.78), 1, 1e-12);
    EXPECT_EQ(weight_of_aside(0.79), 0);
}

TEST(HeiglFrame, GivesACameraAllTheWeightWhereItStands) {
    const Points centres = grid();
    const Points axes(centres.size(), Eigen::Vector3d::UnitZ());
    const Rigid3 eye_from_world{Eigen::Quaterniond::Identity(), -centres[5]};
    const auto weights = HeiglFrame(centres, axes, eye_from_world).weights_towards({1, 2, 7});
    EXPECT_EQ(weights[5], 1);
    EXPECT_EQ(sum_of(weights), 1);
}

TEST(UnstructuredWeights, AreOneAtACameraAndDependOnWhereOnTheRayTheEyeStands) {
    const Points centres = grid();
    const Eigen::Vector3d target(1.7, 1.1, 8);
    const auto at_camera = unstructured_weights(centres, centres[5], target);
    EXPECT_NEAR(at_camera[5], 1, 1e-9);
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

/// About the origin, at these angles from the z axis and these distances.
Eigen::Vector3d seen_at(double angle, double distance) {
    return distance * Eigen::Vector3d(std::sin(angle), 0, std::cos(angle));
}

TEST(UnstructuredWeights, AreOneAtACameraHoweverFarTheOthersAre) {
    // The three others have penalties p, p and 2 p.
    const Points centres{seen_at(0.1, 2), seen_at(0, 5), seen_at(-0.1, 2), seen_at(0.2, 2)};
    const auto weights = unstructured_weights(centres, centres[1], {0, 0, 0});
    EXPECT_NEAR(weights[1], 1, 1e-9);
}

TEST(UnstructuredWeights, OfFourCamerasFallToNoneAtTheFourth) {
    // Penalties 1, 2, 3 and 4 tenths: 3, 2, 1 and 0 quarters.
    const Points centres{seen_at(0.3, 2), seen_at(-0.1, 2), seen_at(0.2, 2), seen_at(-0.4, 2)};
    const auto weights = unstructured_weights(centres, seen_at(0, 3), {0, 0, 0});
    EXPECT_NEAR(weights[0], 1.0 / 6, 1e-5);
    EXPECT_NEAR(weights[1], 3.0 / 6, 1e-5);
    EXPECT_NEAR(weights[2], 2.0 / 6, 1e-5);
    EXPECT_NEAR(weights[3], 0, 1e-5);
}

TEST(UnstructuredWeights, OfFewerThanFourAreAlike) {
    const Eigen::Vector3d eye = seen_at(0, 9);
    const auto weights = unstructured_weights({seen_at(0.1, 2), seen_at(-0.2, 3)}, eye, {0, 0, 0});
    EXPECT_NEAR(weights[0], 0.5, 1e-12);
    EXPECT_NEAR(weights[1], 0.5, 1e-12);
    EXPECT_EQ(unstructured_weights({seen_at(0.1, 2)}, eye, {0, 0, 0})[0], 1);
}

TEST(UnstructuredWeights, OfFourAlikeAreAlike) {
    const Points centres{{0.1, 0, 2}, {0, 0.1, 2}, {-0.1, 0, 2}, {0, -0.1, 2}};
    for (const double weight : unstructured_weights(centres, {0, 0, 2}, {0, 0, 0}))
        EXPECT_NEAR(weight, 0.25, 1e-3);
}

TEST(UnstructuredWeights, DoNotJumpWhereAPhotographEnds) {
    const Points centres{seen_at(0.05, 2), seen_at(-0.1, 2), seen_at(0.15, 2), seen_at(-0.2, 2),
                         seen_at(0.25, 2)};
    const Eigen::Vector3d eye = seen_at(0, 3);
    for (std::size_t leaving = 0; leaving < centres.size(); ++leaving) {
        std::vector<double> shares(centres.size(), 1.0);
        shares[leaving] = 1e-9;
        const auto before = unstructured_weights(centres, eye, {0, 0, 0}, shares);
        Points others = centres;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(leaving));
        const auto after = unstructured_weights(others, eye, {0, 0, 0});
        EXPECT_NEAR(before[leaving], 0, 1e-6);
        for (std::size_t i = 0; i < others.size(); ++i)
            EXPECT_NEAR(before[i < leaving ? i : i + 1], after[i], 1e-6) << leaving;
    }
}

}  // namespace
}  // namespace lumi
