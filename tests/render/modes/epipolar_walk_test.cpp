#include "render/modes/epipolar_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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

bool is_in_picture(const EpipolarWalk::Place& place) {
    return place.x >= 0 && place.y >= 0 && place.x <= kWidth && place.y <= kHeight;
}

/// From near on, as long as the ray is in the picture: the end of this, or nothing at all.
double far_end_from(const EpipolarWalk& walk, double near_end) {
    double q = near_end;
    while (q > 0 && is_in_picture(walk.at(q))) q -= 0.001;
    return std::min(near_end, q + 0.001);
}

TEST(TiledDepth, HoldsEverySampleAndItsKind) {
    const DepthMap depth = depth_with_a_step();
    const TiledDepth tiled(depth);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const auto [inverse_depth, kind] =
                tiled[TiledDepth::column_offset(x) + tiled.row_offset(y)];
            EXPECT_FLOAT_EQ(inverse_depth, depth.inverse_depth(x, y)) << x << ' ' << y;
            EXPECT_EQ(kind, x == 36 ? DepthKind::kFilled : DepthKind::kSeen) << x << ' ' << y;
        }
    }
    EXPECT_FLOAT_EQ(tiled.nearest(), 0.5F);
    EXPECT_TRUE(TiledDepth(DepthMap{}).empty());
}

TEST(EpipolarWalk, PassesNothingThatTheRayMeets) {
    const DepthMap depth = depth_with_a_step();
    const TiledDepth tiled(depth);
    std::mt19937 random(3);
    int passed = 0;
    for (int i = 0; i < 2000; ++i) {
        const EpipolarLine line = random_line(random);
        const EpipolarWalk walk(line, tiled);
        const double from = 0.6;
        const double to = walk.past_free(from, far_end_from(walk, from));
        for (double q = from; q > to; q -= 0.002) {
            const EpipolarWalk::Place place = walk.at(q);
            ++passed;
            ASSERT_GE(q / place.z, interpolated(depth.inverse_depth, place.x, place.y) - 1e-6)
                << "ray " << i << " at " << q;
        }
    }
    EXPECT_GT(passed, 10000);
}

TEST(EpipolarWalk, ComesToWhereTheRayIsAsFarAsSomethingNearby) {
    const TiledDepth tiled(depth_with_a_step());
    std::mt19937 random(4);
    int arrived = 0;
    for (int i = 0; i < 2000; ++i) {
        const EpipolarLine line = random_line(random);
        const EpipolarWalk walk(line, tiled);
        const double far_end = far_end_from(walk, 0.6);
        const double q = walk.past_free(0.6, far_end);
        if (q <= far_end) continue;
        const EpipolarWalk::Place place = walk.at(q);
        ++arrived;
        const TiledDepth::Range& range =
            tiled.fine(std::min(static_cast<int>(place.x), kWidth - 1) / TiledDepth::kFine,
                       std::min(static_cast<int>(place.y), kHeight - 1) / TiledDepth::kFine);
        EXPECT_LE(q / place.z, static_cast<double>(range.nearest) + 1e-6) << "ray " << i;
    }
    EXPECT_GT(arrived, 500);
}

TEST(EpipolarWalk, StaysBehindWhatHidesTheRay) {
    const DepthMap depth = depth_with_a_step();
    const TiledDepth tiled(depth);
    std::mt19937 random(5);
    int hidden = 0;
    for (int i = 0; i < 2000; ++i) {
        const EpipolarLine line = random_line(random);
        const EpipolarWalk walk(line, tiled);
        const double from = 0.3;
        const double to = walk.past_hiding(from, far_end_from(walk, from));
        for (double q = from; q > to; q -= 0.002) {
            const EpipolarWalk::Place place = walk.at(q);
            ++hidden;
            ASSERT_LE(q / place.z, interpolated(depth.inverse_depth, place.x, place.y) + 1e-6)
                << "ray " << i << " at " << q;
        }
    }
    EXPECT_GT(hidden, 100);
}

}  // namespace
}  // namespace lumi
