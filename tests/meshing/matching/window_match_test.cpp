#include "meshing/matching/window_match.h"

#include <gtest/gtest.h>

#include <cmath>

#include "calib/capture/gray.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

/// A slanted wall from two cameras.
class SlantedWall : public testing::Test {
 protected:
    SlantedWall()
        : known_(known_depth_scene({{{0, 0, 2},
                                     {0.5, 0.4, 1},
                                     [](const auto&) { return true; },
                                     noise_texture(0.03, 5)}},
                                   {{0, 0, 0}, {0.12, 0, 0}, {40, 0, 0}}, {})) {
        const auto& views = known_.scene.views;
        gray_ = gray_of(views[0].photograph);
        for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
            warps_.push_back(warp_from(views[0]).to(views[i]));
            views_.push_back(compared_view(warps_.back(), gray_of(views[i].photograph)));
        }
    }

    [[nodiscard]] PixelPlane true_plane(int x, int y) const {
        const FloatImage& q = known_.inverse_depths[0];
        return {q(x, y), q(x + 1, y) - q(x, y), q(x, y + 1) - q(x, y)};
    }

    /// The cost by its definition, in double precision.
    [[nodiscard]] double cost_by_definition(int x, int y, const PixelPlane& plane) const {
        const ReferenceWindow window = reference_window(gray_, x, y);
        const GrayImage other = gray_of(known_.scene.views[1].photograph);
        double mean = 0;
        double square = 0;
        double product = 0;
        std::size_t next = 0;
        for (int dy = -3; dy <= 3; dy += 2) {
            for (int dx = -3; dx <= 3; dx += 2, ++next) {
                const double q = static_cast<double>(plane.at(dx, dy).inverse_depth);
                const Eigen::Vector2d there =
                    warps_[0]
                        .homogeneous_at(Eigen::Vector2d(x + dx + 0.5, y + dy + 0.5), q)
                        .hnormalized() -
                    Eigen::Vector2d(0.5, 0.5);
                const int column = static_cast<int>(there.x());
                const int row = static_cast<int>(there.y());
                const double right = there.x() - column;
                const double down = there.y() - row;
                const double value =
                    (1 - down) *
                        ((1 - right) * other(column, row) + right * other(column + 1, row)) +
                    down *
                        ((1 - right) * other(column, row + 1) + right * other(column + 1, row + 1));
                const double weight = static_cast<double>(window.weights[next]);
                mean += weight * value;
                square += weight * value * value;
                product += static_cast<double>(window.normalised[next]) * value;
            }
        }
        return 1 - product / std::sqrt(square - mean * mean);
    }

    KnownDepthScene known_;
    GrayImage gray_;
    std::vector<InverseDepthWarp> warps_;
    std::vector<ComparedView> views_;
};

TEST_F(SlantedWall, CostsAreThoseOfTheDefinition) {
    for (int y = 40; y < 140; y += 13) {
        for (int x = 60; x < 180; x += 17) {
            for (const float error : {0.0F, 0.01F, -0.03F}) {
                PixelPlane plane = true_plane(x, y);
                plane.inverse_depth += error;
                float costs[2];
                window_costs(reference_window(gray_, x, y), views_, x, y, plane, costs);
                ASSERT_NEAR(costs[0], cost_by_definition(x, y, plane), 2e-3) << x << " " << y;
            }
        }
    }
}

TEST_F(SlantedWall, TheTruePlaneFitsAndAnotherDoesNot) {
    double right = 0;
    double wrong = 0;
    for (int y = 40; y < 140; y += 5) {
        for (int x = 60; x < 180; x += 5) {
            float costs[2];
            const ReferenceWindow window = reference_window(gray_, x, y);
            PixelPlane plane = true_plane(x, y);
            window_costs(window, views_, x, y, plane, costs);
            right += static_cast<double>(costs[0]) / 480;
            plane.inverse_depth += 0.2F;  // Five pixels.
            window_costs(window, views_, x, y, plane, costs);
            wrong += static_cast<double>(costs[0]) / 480;
        }
    }
    EXPECT_LT(right, 0.05);
    EXPECT_GT(wrong, 0.5);
}

TEST_F(SlantedWall, AViewThatDoesNotSeeThePixelSaysSo) {
    float costs[2];
    window_costs(reference_window(gray_, 120, 90), views_, 120, 90, true_plane(120, 90), costs);
    EXPECT_EQ(costs[1], kWindowUnseen);
}

TEST(ReferenceWindow, AsksThePixelsOwnSideOfASilhouette) {
    GrayImage gray(20, 20, 40);
    for (int y = 0; y < 20; ++y) {
        for (int x = 10; x < 20; ++x) gray(x, y) = 200;
    }
    const ReferenceWindow window = reference_window(gray, 9, 10);
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
        const bool own_side = i % 4 < 2;  // Columns 6 and 8; 10 and 12 are bright.
        EXPECT_NEAR(window.weights[i], own_side ? 0.125F : 0.0F, 1e-3F) << i;
    }
    EXPECT_FALSE(reference_window(gray, 3, 10).has_texture);
}

}  // namespace
}  // namespace lumi
