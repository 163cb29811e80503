#include "render/rivals/cone_of_cameras.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace lumi {
namespace {

using Cameras = std::vector<PassedCamera>;

double sum_of_weights(const Cameras& cameras, double radius) {
    double sum = 0;
    for (const PassedCamera& camera : cameras) sum += cone_weight(camera, radius);
    return sum;
}

double bisected_radius(const Cameras& cameras) {
    double low = 0;
    double high = 1e6;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (sum_of_weights(cameras, middle) < 1 ? low : high) = middle;
    }
    return high;
}

/// Nine cameras in the unit square, the nearest to one place in it first.
Cameras random_cameras(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0.01, 1.0);
    Cameras cameras(9);
    for (PassedCamera& camera : cameras)
        camera = {.from_ray = std::hypot(uniform(random) - 0.5, uniform(random) - 0.5),
                  .share = uniform(random)};
    std::sort(cameras.begin(), cameras.end(),
              [](const auto& a, const auto& b) { return a.from_ray < b.from_ray; });
    return cameras;
}

TEST(LeastConeRadius, IsTheOneThatBisectionFinds) {
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        const Cameras cameras = random_cameras(random);
        const double radius = least_cone_radius(cameras);
        EXPECT_NEAR(radius, bisected_radius(cameras), 1e-9 * radius);
        EXPECT_NEAR(sum_of_weights(cameras, radius), 1, 1e-9);
    }
}

TEST(LeastConeRadius, OfTwoCamerasMakesTheirWeightsLinearBetweenThem) {
    const Cameras cameras{{.from_ray = 0.1}, {.from_ray = 0.3}};
    const double radius = least_cone_radius(cameras);
    EXPECT_NEAR(cone_weight(cameras[0], radius), 0.75, 1e-12);
    EXPECT_NEAR(cone_weight(cameras[1], radius), 0.25, 1e-12);
}

TEST(LeastConeRadius, LeavesNoWeightToOthersThanACameraOnTheRay) {
    const Cameras cameras{{.from_ray = 0}, {.from_ray = 0.2}, {.from_ray = 0.5}};
    const double radius = least_cone_radius(cameras);
    EXPECT_EQ(cone_weight(cameras[0], radius), 1);
    EXPECT_NEAR(cone_weight(cameras[1], radius) + cone_weight(cameras[2], radius), 0, 1e-12);
}

TEST(LeastConeRadius, IsEndlessWhereSharesSumToNoMoreThanOneCamera) {
    EXPECT_EQ(least_cone_radius({}), std::numeric_limits<double>::infinity());
    const Cameras cameras{{.from_ray = 0.1, .share = 0.25}, {.from_ray = 9, .share = 0.75}};
    const double radius = least_cone_radius(cameras);
    EXPECT_EQ(radius, std::numeric_limits<double>::infinity());
    EXPECT_EQ(cone_weight(cameras[1], radius), 0.75);
}

TEST(LeastConeRadius, OfCamerasInOnePlaceOnTheRayIsNoneAndTheyCountAlike) {
    const Cameras cameras{{.from_ray = 0}, {.from_ray = 0}, {.from_ray = 0.1}};
    EXPECT_EQ(least_cone_radius(cameras), 0);
    EXPECT_EQ(cone_weight(cameras[0], 0), cone_weight(cameras[1], 0));
    EXPECT_EQ(cone_weight(cameras[2], 0), 0);
}

TEST(LeastConeRadius, DoesNotJumpAsACameraFades) {
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
        const Cameras cameras = random_cameras(random);
        for (std::size_t fading = 0; fading < cameras.size(); ++fading) {
            Cameras faded = cameras;
            faded[fading].share = 1e-9;
            Cameras others = cameras;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(fading));
            const double without = least_cone_radius(others);
            EXPECT_NEAR(least_cone_radius(faded), without, 1e-6 * without);
        }
    }
}

}  // namespace
}  // namespace lumi
