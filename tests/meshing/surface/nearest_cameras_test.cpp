#include "meshing/surface/nearest_cameras.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "calib/capture/degrees.h"
#include "calib/work/error.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

const Eigen::Vector3d kAhead = Eigen::Vector3d::UnitZ();

/// Cameras at these places that look along z.
CameraMesh cameras_at(const Points& places) {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kNearest;
    for (std::size_t i = 0; i < places.size(); ++i)
        mesh.vertices.push_back({places[i], static_cast<int>(i), false, kAhead});
    return mesh;
}

/// Half a unit behind each other, swaying.
CameraMesh row(int count) {
    Points places;
    for (int i = 0; i < count; ++i)
        places.emplace_back(0.05 * std::cos(1.7 * i), 0.05 * std::sin(1.7 * i), 0.5 * i);
    return cameras_at(places);
}

std::vector<double> weights_at_eye(const CameraMesh& mesh, const Eigen::Vector3d& eye,
                                   const Eigen::Vector3d& line_of_sight = kAhead) {
    return weights_by_view(weights_of_eye(mesh, eye, line_of_sight), mesh.vertices.size());
}

/// The mean over an eye's picture.
std::vector<double> mean_weights_at_eye(const CameraMesh& mesh, const Eigen::Vector3d& eye,
                                        const Eigen::Vector3d& line_of_sight) {
    std::vector<double> mean(mesh.vertices.size());
    for (const EyeBlend& blend : blends_of_eye(mesh, eye, line_of_sight)) {
        const auto weights = weights_by_view(blend.weights, mesh.vertices.size());
        for (std::size_t view = 0; view < mean.size(); ++view)
            mean[view] += blend.share * weights[view];
    }
    return mean;
}

TEST(NearestCameras, CountByHowMuchNearerTheyAreThanTheFourth) {
    const CameraMesh mesh = cameras_at({{1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {-4, 0, 0}, {9, 0, 0}});
    const auto weights = weights_at_eye(mesh, Eigen::Vector3d::Zero());
    const double sum = 1 / 1.0 + 1 / 2.0 + 1 / 3.0 - 3 / 4.0;
    EXPECT_NEAR(weights[0], (1 / 1.0 - 1 / 4.0) / sum, 4e-3);
    EXPECT_NEAR(weights[1], (1 / 2.0 - 1 / 4.0) / sum, 4e-3);
    EXPECT_NEAR(weights[2], (1 / 3.0 - 1 / 4.0) / sum, 4e-3);
    EXPECT_EQ(weights[3], 0);
    EXPECT_EQ(weights[4], 0);
}

TEST(NearestCameras, CountTheSameInAnyUnitOfLength) {
    for (const double scale : {1e-9, 1e9}) {
        CameraMesh scaled = row(6);
        for (CameraMesh::Vertex& camera : scaled.vertices) camera.position_in_world *= scale;
        const Eigen::Vector3d eye(0.3, 0.1, 0.8);
        const auto expected = weights_at_eye(row(6), eye);
        const auto weights = weights_at_eye(scaled, scale * eye);
        for (std::size_t view = 0; view < 6; ++view)
            EXPECT_NEAR(weights[view], expected[view], 1e-9);
    }
}

TEST(NearestCameras, GiveACameraItsOwnPictureButForAThousandth) {
    const CameraMesh mesh = row(300);
    for (const CameraMesh::Vertex& camera : mesh.vertices) {
        const auto weights = weights_at_eye(mesh, camera.position_in_world);
        const double own = weights[static_cast<std::size_t>(camera.view_index)];
        EXPECT_GT(own, 1 - 3e-3);
        EXPECT_LT(own, 1);
    }
}

TEST(NearestCameras, AreThoseThatLookWhereTheEyeDoes) {
    // Eight photographs of a panorama, and a hair's breadth between their places.
    CameraMesh panorama;
    panorama.construction = MeshConstruction::kNearest;
    for (int i = 0; i < 8; ++i) {
        const double angle = 45 * i * kRadiansPerDegree;
        panorama.vertices.push_back({{0.01 * std::cos(2.3 * i), 0.01 * std::sin(2.3 * i), 0},
                                     i,
                                     false,
                                     {std::sin(angle), 0, std::cos(angle)}});
    }
    for (int i = 0; i < 8; ++i) {
        const double angle = (45 * i + 10) * kRadiansPerDegree;
        const auto weights =
            weights_at_eye(panorama, {0, 0.03, 0}, {std::sin(angle), 0, std::cos(angle)});
        const std::set<int> expected{(i + 7) % 8, i, (i + 1) % 8};
        for (int view = 0; view < 8; ++view) {
            if (expected.count(view) == 0) {
                EXPECT_EQ(weights[static_cast<std::size_t>(view)], 0) << i << ' ' << view;
            }
        }
        EXPECT_GT(weights[static_cast<std::size_t>(i)], 0.2) << i;
    }
}

TEST(NearestCameras, CountContinuouslyWhereverTheEyeGoesAndTurns) {
    const CameraMesh mesh = row(8);
    std::mt19937 random(3);
    constexpr int kSteps = 4000;
    for (int path = 0; path < 20; ++path) {
        const Eigen::Vector3d from = 2 * random_direction(random) + Eigen::Vector3d(0, 0, 1);
        const Eigen::Vector3d to = 2 * random_direction(random) + Eigen::Vector3d(0, 0, 1);
        const Eigen::Vector3d looks_first = random_direction(random);
        const Eigen::Vector3d looks_last = random_direction(random);
        std::vector<double> last;
        for (int step = 0; step <= kSteps; ++step) {
            const double share = static_cast<double>(step) / kSteps;
            const auto weights = mean_weights_at_eye(
                mesh, from + share * (to - from),
                (looks_first + share * (looks_last - looks_first)).normalized());
            double sum = 0;
            for (std::size_t view = 0; view < weights.size(); ++view) {
                EXPECT_GE(weights[view], 0);
                sum += weights[view];
                // A step of at most 1e-3 past cameras that stand half a unit apart.
                if (!last.empty()) {
                    EXPECT_LT(std::abs(weights[view] - last[view]), 0.03);
                }
            }
            EXPECT_NEAR(sum, 1, 1e-12);
            last = weights;
        }
    }
}

TEST(NearestCameras, AreExchangedGraduallyBetweenFourThatAreEquallyFar) {
    const CameraMesh square = cameras_at({{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}});
    const Eigen::Vector3d middle(0, 0, -2);
    const auto at_middle = mean_weights_at_eye(square, middle, kAhead);
    for (const double x : {-1e-6, 1e-6})
        for (const double y : {-1e-6, 1e-6}) {
            const auto beside =
                mean_weights_at_eye(square, middle + Eigen::Vector3d(x, y, 0), kAhead);
            for (std::size_t view = 0; view < 4; ++view)
                EXPECT_NEAR(beside[view], at_middle[view], 1e-2);
        }
}

TEST(NearestCameras, AreAllWhereThereAreNoMoreThanThree) {
    EXPECT_EQ(weights_at_eye(cameras_at({{1, 2, 3}}), {5, 5, 5})[0], 1);
    const auto two = weights_at_eye(cameras_at({{1, 0, 0}, {-3, 0, 0}}), Eigen::Vector3d::Zero());
    EXPECT_NEAR(two[0], 0.75, 2e-3);
    EXPECT_NEAR(two[1], 0.25, 2e-3);
}

TEST(NearestCameras, SumToOneWhereAllAreEquallyFar) {
    const CameraMesh mesh = cameras_at({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}});
    const auto weights = weights_at_eye(mesh, Eigen::Vector3d::Zero());
    double sum = 0;
    for (const double weight : weights) sum += weight;
    EXPECT_NEAR(sum, 1, 1e-12);
    sum = 0;
    for (const double weight : weights_at_eye(cameras_at(Points(5, {1, 1, 1})), {1, 1, 1}))
        sum += weight;
    EXPECT_NEAR(sum, 1, 1e-12);
    // Those at the eye, not those elsewhere.
    Points places{{9, 0, 0}, {8, 0, 0}};
    places.resize(6, {1, 0, 0});
    const auto at_the_eye = weights_at_eye(cameras_at(places), {1, 0, 0});
    EXPECT_EQ(at_the_eye[0], 0);
    EXPECT_EQ(at_the_eye[1], 0);
}

/// As an untrusted package may have them.
TEST(NearestCameras, WeighNumbersThatOverflowFinitely) {
    CameraMesh mesh = row(5);
    for (CameraMesh::Vertex& camera : mesh.vertices) camera.position_in_world *= 1e308;
    for (const double far : {0.0, 1e308, std::numeric_limits<double>::quiet_NaN()}) {
        const RayWeights weights = weights_of_eye(mesh, Eigen::Vector3d::Constant(far), kAhead);
        double sum = 0;
        for (const double weight : weights.weights) sum += weight;
        EXPECT_NEAR(sum, 1, 1e-12);
    }
}

TEST(NearestCameras, AreLinkedWithThoseBeforeAndBehindThemOnAWalk) {
    const auto neighbours = neighbouring_views(row(9), 9);
    EXPECT_EQ(neighbours[4], (std::set<int>{2, 3, 5, 6}));
    EXPECT_EQ(neighbours[0].count(1), 1U);
    EXPECT_EQ(neighbours[0].count(8), 0U);
}

TEST(NearestCameras, AreRefusedWithFaces) {
    CameraMesh mesh = row(5);
    EXPECT_NO_THROW(validate(mesh, 5, "here"));
    for (const double length : {0.5, 1e307, std::numeric_limits<double>::infinity()}) {
        mesh.vertices[2].line_of_sight_in_world = {length, 0, 0};
        EXPECT_THROW(validate(mesh, 5, "here"), Error) << length;
    }
    mesh = row(5);
    mesh.faces.push_back({0, 1, 2});
    EXPECT_THROW(validate(mesh, 5, "here"), Error);
}

}  // namespace
}  // namespace lumi
