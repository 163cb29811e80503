#include "meshing/fusion/surface_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calib/work/error.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

TEST(SurfacePoints, PhotographsOfOneBurstDoNotConfirmEachOther) {
    // Three of one place that are wrong by ten pixels, each another way, and two from either side.
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 2}, {0, 0, 1}, [](const auto&) { return true; }, noise_texture(0.1, 5)}},
        {{0, 0, 0}, {1e-4, 0, 0}, {-1e-4, 0, 0}, {-0.12, 0, 0}, {0.12, 0, 0}}, {});
    std::vector<DepthMap> maps;
    for (const FloatImage& truth : known.inverse_depths) {
        maps.push_back({truth, GrayImage(truth.width(), truth.height(), 255)});
    }
    const double pixel = 1 / (focal_length_px(small_camera()).x() * 0.12);
    for (std::size_t i = 0; i < 3; ++i) {
        const double wrong_px = 10 + 3.0 * static_cast<double>(i);
        for (float& q : maps[i].inverse_depth.pixels()) q += static_cast<float>(wrong_px * pixel);
    }
    std::vector<PicturedView> views;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const DepthView& view = known.scene.views[i];
        views.push_back({&view.photograph, view.camera, view.cam_from_world, &maps[i]});
    }
    SilentProgress progress;
    const SurfacePoints found = surface_points(views, {}, 1, progress);
    ASSERT_FALSE(found.points.empty());
    for (const SurfacePoint& point : found.points) {
        ASSERT_NEAR(point.position.z(), 2, 0.01) << point.position.transpose();
    }
}

TEST(SurfacePoints, WhatWasFilledConfirmsNothing) {
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 2}, {0, 0, 1}, [](const auto&) { return true; }, noise_texture(0.1, 5)}},
        {{0, 0, 0}, {-0.12, 0, 0}, {0.12, 0, 0}}, {});
    SilentProgress progress;
    for (const std::uint8_t confidence :
         {std::uint8_t{0}, kFilledBeforeBackground, std::uint8_t{128}}) {
        std::vector<DepthMap> maps;
        for (const FloatImage& truth : known.inverse_depths) {
            maps.push_back({truth, GrayImage(truth.width(), truth.height(),
                                             maps.empty() ? std::uint8_t{255} : confidence)});
        }
        std::vector<PicturedView> views;
        for (std::size_t i = 0; i < maps.size(); ++i) {
            const DepthView& view = known.scene.views[i];
            views.push_back({&view.photograph, view.camera, view.cam_from_world, &maps[i]});
        }
        EXPECT_EQ(surface_points(views, {}, 1, progress).points.empty(), confidence < 128)
            << static_cast<int>(confidence);
    }
}

/// A wall seen by five cameras: each has four others to agree with.
TEST(SurfacePoints, OfAsManyAgreeingViewsAsThereAreAndNoMore) {
    const KnownDepthScene known = known_depth_scene(
        {{{0, 0, 2}, {0, 0, 1}, [](const auto&) { return true; }, noise_texture(0.1, 5)}},
        {{0, 0, 0}, {0.06, 0, 0}, {-0.06, 0, 0}, {-0.12, 0, 0}, {0.12, 0, 0}}, {});
    std::vector<DepthMap> maps;
    std::vector<PicturedView> views;
    for (const FloatImage& truth : known.inverse_depths) {
        maps.push_back({truth, GrayImage(truth.width(), truth.height(), 255)});
    }
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const DepthView& view = known.scene.views[i];
        views.push_back({&view.photograph, view.camera, view.cam_from_world, &maps[i]});
    }
    SilentProgress progress;
    EXPECT_FALSE(surface_points(views, {.min_agreeing_views = 4}, 1, progress).points.empty());
    for (const int agreeing : {5, 9}) {
        try {
            (void)surface_points(views, {.min_agreeing_views = agreeing}, 1, progress);
            ADD_FAILURE() << "accepted " << agreeing;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-FUSE-OPTION");
            EXPECT_NE(std::string(error.what()).find(std::to_string(agreeing)), std::string::npos);
            EXPECT_NE(std::string(error.what()).find("4"), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace lumi
