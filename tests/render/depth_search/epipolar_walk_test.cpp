#include "render/depth_search/epipolar_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "render/depth_mesh/surface_tears.h"

namespace lumi {
namespace {

constexpr int kWidth = 53;
constexpr int kHeight = 39;

/// A slanted ground that is wavy, and a thing before it; filled beside it.
DepthMap depth_with_a_step() {
    DepthMap depth{FloatImage(kWidth, kHeight), GrayImage(kWidth, kHeight, 255)};
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const bool is_thing = std::abs(x - 30) < 6 && std::abs(y - 17) < 9;
            depth.inverse_depth(x, y) = is_thing
                                            ? 0.5F
                                            : 0.1F + 0.002F * static_cast<float>(x) +
                                                  0.01F * std::sin(0.9F * static_cast<float>(y));
            if (x == 36) depth.confidence(x, y) = 0;
        }
    }
    return depth;
}

TiledDepth tiled_depth(const DepthMap& depth) {
    return {depth, torn_squares(depth.inverse_depth, {20, 20})};
}

double interpolated(const FloatImage& map, double x, double y) {
    const double from_left = std::clamp(x - 0.5, 0.0, kWidth - 1.0);
    const double from_top = std::clamp(y - 0.5, 0.0, kHeight - 1.0);
    const int left = static_cast<int>(from_left);
    const int top = static_cast<int>(from_top);
    const auto row_at = [&](int row) {
        const double a = static_cast<double>(map(left, row));
        const double b = static_cast<double>(map(std::min(left + 1, kWidth - 1), row));
        return std::lerp(a, b, from_left - left);
    };
    return std::lerp(row_at(top), row_at(std::min(top + 1, kHeight - 1)), from_top - top);
}

/// A ray that is at (x, y) at infinity and gets nearer from there on.
EpipolarLine random_line(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0, 1);
    const double z = 0.7 + 0.6 * share(random);
    return {{z * kWidth * share(random), z * kHeight * share(random), z},
            {80 * (share(random) - 0.5), 80 * (share(random) - 0.5), 0.4 * (share(random) - 0.5)}};
}

/// A ray that comes to the view from behind it, and is nearest to it where it is farthest from the
/// eye.
EpipolarLine line_that_comes_back(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0, 1);
    const EpipolarLine line = random_line(random);
    return {-0.1 * line.at_infinity, line.at_infinity + 0.1 * line.per_inverse_depth};
}

bool is_in_picture(const Eigen::Vector3d& place) {
    return place.z() > 0 && place.x() >= 0 && place.y() >= 0 && place.x() <= kWidth * place.z() &&
           place.y() <= kHeight * place.z();
}

/// From near on, as long as the ray is in the picture.
RayStretch stretch_from(const EpipolarLine& line, double near_end) {
    double far_end = near_end;
    while (far_end > 0.001 && is_in_picture(line.homogeneous_at(far_end - 0.001))) far_end -= 0.001;
    return {near_end, far_end};
}

/// Shares of the way up to this one.
std::vector<double> shares_up_to(double end) {
    std::vector<double> shares;
    for (double share = 0; share < end; share += 0.004) shares.push_back(share);
    return shares;
}

TEST(TiledDepth, HoldsOfEverySampleItsKindAndWhatTears) {
    const DepthMap depth = depth_with_a_step();
    const TiledDepth tiled = tiled_depth(depth);
    const GrayImage torn = torn_squares(depth.inverse_depth, {20, 20});
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const TiledDepth::Sample sample =
                tiled[TiledDepth::column_offset(x) + tiled.row_offset(y)];
            EXPECT_FLOAT_EQ(sample.inverse_depth, depth.inverse_depth(x, y)) << x << ' ' << y;
            EXPECT_EQ(sample.kind, x == 36 ? DepthKind::kFilled : DepthKind::kSeen)
                << x << ' ' << y;
            EXPECT_EQ(sample.is_torn, torn(x, y) != 0) << x << ' ' << y;
        }
    }
    EXPECT_FLOAT_EQ(tiled.nearest(), 0.5F);
    const auto& values = depth.inverse_depth.pixels();
    EXPECT_FLOAT_EQ(tiled.farthest(), *std::min_element(values.begin(), values.end()));
    EXPECT_TRUE(TiledDepth().empty());
}

TEST(EpipolarWalk, PlacesAndInverseDepthsAreThoseOfTheLine) {
    const TiledDepth tiled = tiled_depth(depth_with_a_step());
    std::mt19937 random(2);
    int checked = 0;
    for (int i = 0; i < 200; ++i) {
        const bool comes_back = i % 2 == 1;
        const EpipolarLine line = comes_back ? line_that_comes_back(random) : random_line(random);
        const RayStretch stretch = stretch_from(line, 0.6);
        if (!is_in_picture(line.homogeneous_at(0.6)) || stretch.far_end == stretch.near_end)
            continue;
        const EpipolarWalk walk(line, stretch, tiled);
        EXPECT_NEAR(walk.inverse_depth_in_eye(0), stretch.near_end, 1e-9);
        EXPECT_NEAR(walk.inverse_depth_in_eye(1), stretch.far_end, 1e-9);
        for (const double share : shares_up_to(1)) {
            const double in_eye = walk.inverse_depth_in_eye(share);
            const Eigen::Vector3d expected = line.homogeneous_at(in_eye);
            const EpipolarWalk::Place place = walk.at(share);
            EXPECT_NEAR(place.x, expected.x() / expected.z(), 1e-6) << i << ' ' << share;
            EXPECT_NEAR(place.y, expected.y() / expected.z(), 1e-6) << i << ' ' << share;
            EXPECT_NEAR(place.inverse_depth, in_eye / expected.z(), 1e-9) << i << ' ' << share;
            EXPECT_NEAR(walk.meets(place.inverse_depth), share, 1e-6) << i << ' ' << share;
            ++checked;
        }
        const EpipolarWalk::Place begin = walk.at(0);
        const EpipolarWalk::Place next = walk.at(walk.per_sample());
        EXPECT_NEAR(std::hypot(next.x - begin.x, next.y - begin.y), 1, 1e-9) << i;
        EXPECT_NEAR(next.inverse_depth - begin.inverse_depth, walk.inverse_depth_per_sample(), 1e-9)
            << i;
    }
    EXPECT_GT(checked, 10000);
}

TEST(EpipolarWalk, StandsStillAtTheViewsOwnCentre) {
    const TiledDepth tiled = tiled_depth(depth_with_a_step());
    const EpipolarWalk walk({{20, 10, 1}, {0, 0, 0}}, {0.6, 0.01}, tiled);
    const float inverse_depth = tiled.fine(20 / TiledDepth::kFine, 10 / TiledDepth::kFine).nearest;
    const double met = walk.past_free(0);
    EXPECT_NEAR(walk.inverse_depth_in_eye(met), static_cast<double>(inverse_depth), 1e-6);
    EXPECT_EQ(walk.at(met).x, 20);
    EXPECT_EQ(walk.past_hiding(0.999), 1);
}

TEST(EpipolarWalk, PassesNothingThatTheRayMeets) {
    const DepthMap depth = depth_with_a_step();
    const TiledDepth tiled = tiled_depth(depth);
    std::mt19937 random(3);
    std::size_t passed = 0;
    for (int i = 0; i < 2000; ++i) {
        const EpipolarLine line = random_line(random);
        if (!is_in_picture(line.homogeneous_at(0.6))) continue;
        const EpipolarWalk walk(line, stretch_from(line, 0.6), tiled);
        for (const double share : shares_up_to(walk.past_free(0))) {
            const EpipolarWalk::Place place = walk.at(share);
            ++passed;
            ASSERT_GE(place.inverse_depth,
                      interpolated(depth.inverse_depth, place.x, place.y) - 1e-6)
                << "ray " << i << " at " << share;
        }
    }
    EXPECT_GT(passed, 10000U);
}

TEST(EpipolarWalk, ComesToWhereTheRayIsAsFarAsSomethingNearby) {
    const TiledDepth tiled = tiled_depth(depth_with_a_step());
    std::mt19937 random(4);
    int arrived = 0;
    for (int i = 0; i < 2000; ++i) {
        const EpipolarLine line = random_line(random);
        if (!is_in_picture(line.homogeneous_at(0.6))) continue;
        const EpipolarWalk walk(line, stretch_from(line, 0.6), tiled);
        const double share = walk.past_free(0);
        if (share >= 1) continue;
        const EpipolarWalk::Place place = walk.at(share);
        ++arrived;
        const TiledDepth::Range& range =
            tiled.fine(std::min(static_cast<int>(place.x), kWidth - 1) / TiledDepth::kFine,
                       std::min(static_cast<int>(place.y), kHeight - 1) / TiledDepth::kFine);
        EXPECT_LE(place.inverse_depth, static_cast<double>(range.nearest) + 1e-6) << "ray " << i;
    }
    EXPECT_GT(arrived, 500);
}

TEST(EpipolarWalk, StaysBehindWhatHidesTheRay) {
    const DepthMap depth = depth_with_a_step();
    const TiledDepth tiled = tiled_depth(depth);
    std::mt19937 random(5);
    std::size_t hidden = 0;
    for (int i = 0; i < 2000; ++i) {
        const EpipolarLine line = i % 4 == 0 ? line_that_comes_back(random) : random_line(random);
        if (!is_in_picture(line.homogeneous_at(0.3))) continue;
        const EpipolarWalk walk(line, stretch_from(line, 0.3), tiled);
        for (const double share : shares_up_to(walk.past_hiding(0))) {
            const EpipolarWalk::Place place = walk.at(share);
            ++hidden;
            ASSERT_LE(place.inverse_depth,
                      interpolated(depth.inverse_depth, place.x, place.y) + 1e-6)
                << "ray " << i << " at " << share;
        }
    }
    EXPECT_GT(hidden, 100U);
}

}  // namespace
}  // namespace lumi
