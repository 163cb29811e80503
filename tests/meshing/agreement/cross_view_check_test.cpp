#include "meshing/agreement/cross_view_check.h"

#include <gtest/gtest.h>

#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

KnownDepthScene wall_from(const std::vector<Eigen::Vector3d>& centres) {
    return known_depth_scene({{{0, 0, 2},
                               {0.2, 0, 1},
                               [](const auto&) { return true; },
                               [](const auto&) { return 100.0; }}},
                             centres, {});
}

KnownDepthScene wall() { return wall_from(cross_of_centres(0.1)); }

std::vector<DepthEstimate> exact_estimates(const KnownDepthScene& known) {
    std::vector<DepthEstimate> estimates;
    for (const FloatImage& truth : known.inverse_depths) {
        estimates.push_back(
            {{truth, GrayImage(truth.width(), truth.height(), 255)}, "sweep", true});
    }
    return estimates;
}

TEST(CrossViewCheck, ExactViewsAgreeAndKeepTheirDepth) {
    const KnownDepthScene known = wall();
    const DepthMap map = cross_view_check(known.scene, exact_estimates(known), 0);
    for (int y = 30; y < 150; ++y) {
        for (int x = 30; x < 210; ++x) {
            ASSERT_EQ(map.confidence(x, y), 255) << x << " " << y;
            ASSERT_NEAR(map.inverse_depth(x, y), known.inverse_depths[0](x, y), 1e-5F);
        }
    }
}

TEST(CrossViewCheck, AWrongDepthIsNotConfirmed) {
    const KnownDepthScene known = wall();
    std::vector<DepthEstimate> estimates = exact_estimates(known);
    for (float& value : estimates[0].map.inverse_depth.pixels()) value += 5.0F / 22.0F;
    const DepthMap map = cross_view_check(known.scene, estimates, 0);
    EXPECT_EQ(map.confidence, GrayImage(240, 180, 0));
}

TEST(CrossViewCheck, OneOfTwoNeighboursGivesHalfTheConfidence) {
    const KnownDepthScene known = wall();
    std::vector<DepthEstimate> estimates = exact_estimates(known);
    for (const std::size_t j : {2U, 3U, 4U}) estimates[j].map.confidence = GrayImage(240, 180, 0);
    EXPECT_EQ(cross_view_check(known.scene, estimates, 0).confidence(120, 90), 128);
}

void move_by(double pixels_of_disparity, DepthEstimate& estimate) {
    const auto step = static_cast<float>(pixels_of_disparity / 22);
    for (float& value : estimate.map.inverse_depth.pixels()) value += step;
}

TEST(CrossViewCheck, AViewInTheSamePlaceAgreesWithAnythingAndIsNoWitness) {
    const KnownDepthScene known = wall_from({{0, 0, 0}, {1e-4, 0, 0}, {0.1, 0, 0}});
    std::vector<DepthEstimate> estimates = exact_estimates(known);
    EXPECT_EQ(cross_view_check(known.scene, estimates, 0).confidence(120, 90), 128)
        << "the third view alone confirms what is right";
    move_by(5, estimates[0]);
    EXPECT_EQ(cross_view_check(known.scene, estimates, 0).confidence, GrayImage(240, 180, 0));
    move_by(-3, estimates[1]);
    EXPECT_EQ(cross_view_check(known.scene, estimates, 0).confidence, GrayImage(240, 180, 0));
}

TEST(CrossViewCheck, ANearNeighbourAgreesWithinTwoPixelsOfTheFastest) {
    const KnownDepthScene known = wall_from({{0, 0, 0}, {0.01, 0, 0}, {0.1, 0, 0}});
    for (const double off_px : {1.7, 2.3}) {
        std::vector<DepthEstimate> estimates = exact_estimates(known);
        move_by(off_px, estimates[0]);  // A fifth of a pixel as the near neighbour sees it.
        EXPECT_EQ(cross_view_check(known.scene, estimates, 0).confidence(120, 90) != 0, off_px < 2)
            << off_px;
    }
}

TEST(CrossViewCheck, ANeighbourHalfAsFarAsideAgreesWithinAPixel) {
    const KnownDepthScene known = wall_from({{0, 0, 0}, {0.05, 0, 0}, {0.1, 0, 0}});
    std::vector<DepthEstimate> estimates = exact_estimates(known);
    estimates[2].map.confidence = GrayImage(240, 180, 0);
    move_by(1.9, estimates[0]);
    EXPECT_EQ(cross_view_check(known.scene, estimates, 0).confidence(120, 90), 128);
}

TEST(CrossViewCheck, AgreeingViewsMeetInTheMiddle) {
    const KnownDepthScene known = wall();
    std::vector<DepthEstimate> estimates = exact_estimates(known);
    const float half_a_pixel = 0.5F / 22.0F;
    for (float& value : estimates[0].map.inverse_depth.pixels()) value += half_a_pixel;
    const DepthMap map = cross_view_check(known.scene, estimates, 0);
    EXPECT_NEAR(map.inverse_depth(120, 90) - known.inverse_depths[0](120, 90), half_a_pixel / 5,
                2e-4F);
}

TEST(RemoveSpeckles, TakesIslandsAndLeavesLand) {
    DepthMap map{FloatImage(40, 30, 0.5F), GrayImage(40, 30, 255)};
    for (int y = 10; y < 13; ++y) {
        for (int x = 10; x < 13; ++x) map.inverse_depth(x, y) = 0.9F;
    }
    remove_speckles(map, 0.1, 10);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            const bool island = x >= 10 && x < 13 && y >= 10 && y < 13;
            ASSERT_EQ(map.confidence(x, y), island ? 0 : 255) << x << " " << y;
        }
    }
}

}  // namespace
}  // namespace lumi
