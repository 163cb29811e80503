#include "meshing/agreement/surrounding_depth.h"

#include <gtest/gtest.h>

#include "meshing/filling/edge_aware_fill.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

/// A slanted wall behind a board that fills the left of the first view; the second view stands to
/// the right and sees more of the wall.
KnownDepthScene board_before_wall() {
    return known_depth_scene(
        {{{0, 0, 4}, {0.15, 0, 1}, [](const auto&) { return true; }, noise_texture(0.04, 5)},
         {{0, 0, 1.5},
          {0, 0, 1},
          [](const Eigen::Vector3d& p) { return p.x() < 0.5; },
          noise_texture(0.02, 8)}},
        {{0, 0, 0}, {1.2, 0, 0}}, {0.1, 1.0});
}

DepthMap nothing_within() { return {FloatImage(240, 180), GrayImage(240, 180)}; }

TEST(SurroundingDepth, KnowsBeyondTheBorderWhatANeighbourSees) {
    const KnownDepthScene known = board_before_wall();
    std::vector<DepthMap> maps;
    for (const FloatImage& truth : known.inverse_depths) {
        maps.push_back({truth, GrayImage(240, 180, 255)});
    }
    const SurroundingDepth around = surrounding_depth(known.scene, maps, 0, nothing_within());
    const DepthView& view = known.scene.views[0];
    int hits = 0;
    for (int y = 40; y < 140; ++y) {
        for (int x = 250; x < 290; ++x) {
            const int column = x + around.margin_x;
            const int row = y + around.margin_y;
            if (around.map.confidence(column, row) == 0) continue;
            ++hits;
            const Eigen::Vector3d ray = unproject(view.camera, Eigen::Vector2d(x + 0.5, y + 0.5));
            // The wall: 0.15 X + Z = 4.
            const double truth = (0.15 * ray.x() + 1) / 4;
            ASSERT_NEAR(around.map.inverse_depth(column, row), truth, 2e-3) << x << " " << y;
        }
    }
    EXPECT_GT(hits, 3600);
    EXPECT_EQ(around.map.confidence(around.margin_x + 120, around.margin_y + 90), 0)
        << "nothing of the picture itself";
}

TEST(SurroundingDepth, LetsTheFillContinueABackgroundThatTheViewSeesAlone) {
    const KnownDepthScene known = board_before_wall();
    std::vector<DepthMap> maps;
    for (const FloatImage& truth : known.inverse_depths) {
        maps.push_back({truth, GrayImage(240, 180, 255)});
    }
    // The strip of wall beside the board is unknown in the first view.
    DepthMap map = maps[0];
    for (std::size_t i = 0; i < map.confidence.pixels().size(); ++i) {
        if (map.inverse_depth.pixels()[i] < 0.5F) {
            map.confidence.pixels()[i] = 0;
            map.inverse_depth.pixels()[i] = 0;
        }
    }
    const double one_pixel = 1 / known.scene.views[0].disparity_px_per_inverse_depth;
    const SurroundingDepth around = surrounding_depth(known.scene, maps, 0, nothing_within());
    continue_known_depth(map, FloatImage(240, 180, 0.5F), one_pixel, around);
    smooth_filled_depth(map, known.scene.views[0].photograph, one_pixel);
    const FloatImage errors = errors_px(map, known.inverse_depths[0], known.scene.views[0]);
    int right = 0;
    int all = 0;
    for (int y = 20; y < 160; ++y) {
        for (int x = 0; x < 240; ++x) {
            if (known.inverse_depths[0](x, y) > 0.5F) continue;
            ++all;
            if (errors(x, y) <= 2.0F) ++right;
        }
    }
    ASSERT_GT(all, 2000);
    EXPECT_GT(right, 0.85 * all);
}

}  // namespace
}  // namespace lumi
