#include "meshing/depth_scene/view_mask.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "meshing/depth/depth_stage.h"
#include "tests/calib/scratch_folder.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

/// A textured ball of pixels before noisy black cloth.
DepthScene before_black_cloth(int views) {
    DepthScene scene;
    std::mt19937 random(4);
    for (int i = 0; i < views; ++i) {
        DepthView view;
        view.name = "view" + std::to_string(i) + ".jpg";
        view.camera = small_camera();
        view.photograph = ColorImage(240, 180);
        for (int y = 0; y < 180; ++y) {
            for (int x = 0; x < 240; ++x) {
                const bool is_ball = (x - 120) * (x - 120) + (y - 90) * (y - 90) < 60 * 60;
                const int noise = static_cast<int>(random() % 8);
                const auto level = static_cast<std::uint8_t>(is_ball ? 90 + 10 * noise : noise);
                view.photograph(x, y) = {level, level, level};
            }
        }
        view.photograph(120, 90) = {0, 0, 0};  // A dark spot on the ball.
        scene.views.push_back(std::move(view));
    }
    return scene;
}

TEST(ViewMask, FindsBlackClothAndKeepsDarkSpotsOfTheScene) {
    const DepthScene scene = before_black_cloth(4);
    const auto background = plain_background(scene);
    ASSERT_TRUE(background);
    EXPECT_LT(background->g, 8);
    const GrayImage mask = mask_of_background(scene.views[0].photograph, *background);
    EXPECT_EQ(mask(3, 3), 0);
    EXPECT_EQ(mask(120, 90), 255);
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 240; ++x) {
            const bool is_ball = (x - 120) * (x - 120) + (y - 90) * (y - 90) < 60 * 60;
            ASSERT_EQ(mask(x, y) != 0, is_ball) << x << " " << y;
        }
    }
}

TEST(ViewMask, ATexturedSceneHasNoPlainBackground) {
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 2}, {0, 0, 1}, [](const auto&) { return true; }, noise_texture(0.03, 5)}},
        cross_of_centres(0.1), {});
    EXPECT_FALSE(plain_background(known.scene));
}

TEST(ViewMask, APlainWallIsNoBackgroundOfNothing) {
    DepthScene scene = before_black_cloth(3);
    for (DepthView& view : scene.views) view.photograph = ColorImage(240, 180, {128, 128, 128});
    EXPECT_FALSE(plain_background(scene));
}

/// Points of a grid over the whole picture, every so many pixels on the ball and beside it.
void place_points(DepthScene& scene, int on_ball_px, int beside_px) {
    for (DepthView& view : scene.views) {
        for (int y = 0; y < 180; ++y) {
            for (int x = 0; x < 240; ++x) {
                const bool is_ball = (x - 120) * (x - 120) + (y - 90) * (y - 90) < 60 * 60;
                const int every_px = is_ball ? on_ball_px : beside_px;
                if (x % every_px == 0 && y % every_px == 0)
                    view.points.push_back({{x + 0.5, y + 0.5}, is_ball ? 1.0 : 0.5});
            }
        }
    }
}

TEST(ViewMask, APaleWallThatPointsWereFoundOnBelongsToTheScene) {
    const auto background_of = [](int on_ball_px, int beside_px) {
        DepthScene scene = before_black_cloth(4);
        place_points(scene, on_ball_px, beside_px);
        return scene_masks(scene, {}, true, 1).background;
    };
    EXPECT_FALSE(background_of(8, 8));
    EXPECT_FALSE(background_of(5, 10)) << "a quarter as many";
    EXPECT_TRUE(background_of(5, 20)) << "creases of a cloth";
    EXPECT_TRUE(scene_masks(before_black_cloth(4), {}, true, 1).background) << "nobody knows";
}

TEST(DepthStage, WhatAMaskLeavesOutIsInfinitelyFarAndTheRestIsUnharmed) {
    const ScratchFolder folder;
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 2}, {0.1, 0, 1}, [](const auto&) { return true; }, noise_texture(0.03, 5)}},
        cross_of_centres(0.12), {});
    const PosedPhotographs photographs = written(known, folder.path());
    GrayImage mask(240, 180, 255);
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 80; ++x) mask(x, y) = 0;
    }
    for (const View& view : photographs.capture.views) {
        write_png(folder.path() / "masks" / view.name, mask);
    }
    SilentProgress progress;
    DepthOptions options;
    options.mask_folder = folder.path() / "masks";
    const DepthResult result = estimate_depth(photographs, {0, 1, 2, 3, 4}, options, 2, progress);
    const DepthMap& map = result.depth_maps[0];
    EXPECT_NEAR(result.evidence[0].background_share, 1.0 / 3, 1e-9);
    EXPECT_EQ(map.inverse_depth(40, 90), 0.0F);
    EXPECT_EQ(map.confidence(40, 90), 255);
    EXPECT_NEAR(map.inverse_depth(160, 90), known.inverse_depths[0](160, 90), 0.01F);
}

TEST(DepthStage, APlainPartOfTheSubjectIsNotContinuedFromTheBackground) {
    const ScratchFolder folder;
    // A card whose right third is without texture, before nothing.
    const auto is_card = [](const Eigen::Vector3d& at) {
        return std::abs(at.x()) < 0.5 && std::abs(at.y()) < 0.4;
    };
    const auto gray = [noise = noise_texture(0.03, 5)](const Eigen::Vector3d& at) {
        return at.x() > 0.17 ? 120.0 : noise(at);
    };
    const KnownDepthScene known =
        known_depth_scene({{{0, 0, 2}, {0, 0, 1}, is_card, gray}}, cross_of_centres(0.12), {});
    const PosedPhotographs photographs = written(known, folder.path());
    for (std::size_t i = 0; i < photographs.capture.views.size(); ++i) {
        GrayImage mask(240, 180, 255);
        for (std::size_t at = 0; at < mask.pixels().size(); ++at) {
            if (known.inverse_depths[i].pixels()[at] == 0) mask.pixels()[at] = 0;
        }
        write_png(folder.path() / "masks" / photographs.capture.views[i].name, mask);
    }
    SilentProgress progress;
    DepthOptions options;
    options.mask_folder = folder.path() / "masks";
    const DepthResult result = estimate_depth(photographs, {0, 1, 2, 3, 4}, options, 2, progress);
    for (std::size_t at = 0; at < result.depth_maps[0].confidence.pixels().size(); ++at) {
        const float truth = known.inverse_depths[0].pixels()[at];
        if (truth == 0) continue;
        ASSERT_NEAR(result.depth_maps[0].inverse_depth.pixels()[at], truth, 0.05F) << at;
        ASSERT_GT(result.depth_maps[0].confidence.pixels()[at], 0) << at;
    }
}

}  // namespace
}  // namespace lumi
