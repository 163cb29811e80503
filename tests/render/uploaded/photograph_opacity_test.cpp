#include "render/uploaded/photograph_opacity.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr double kDisparity_px = 100.0;

/// 40 x 30 pixels, near and bright to the left of column 20, far and dark to the right of it.
LumigraphView view_of_an_edge() {
    LumigraphView view;
    view.camera = pinhole_camera(40, 30, 40);
    view.photograph = ColorImage(40, 30, {30, 30, 30});
    view.depth = {FloatImage(40, 30, 0.1F), GrayImage(40, 30, 255)};
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 20; ++x) {
            view.photograph(x, y) = {200, 200, 200};
            view.depth.inverse_depth(x, y) = 0.5F;
        }
    }
    return view;
}

TEST(PhotographOpacity, FadesInFromTheBorder) {
    LumigraphView view = view_of_an_edge();
    view.depth = {};
    const GrayImage opacity = photograph_opacity(view, kDisparity_px);
    EXPECT_EQ(opacity(20, 15), 255);
    EXPECT_EQ(opacity(0, 15), 16);  // Half a pixel of eight.
    EXPECT_EQ(opacity(39, 15), 16);
    EXPECT_EQ(opacity(20, 0), 16);
    for (int x = 1; x < 8; ++x) EXPECT_GT(opacity(x, 15), opacity(x - 1, 15));
}

TEST(PhotographOpacity, PixelsOfTwoSurfacesCountLittle) {
    const GrayImage opacity = photograph_opacity(view_of_an_edge(), kDisparity_px);
    EXPECT_EQ(opacity(17, 15), 255);
    EXPECT_EQ(opacity(19, 15), 32);
    EXPECT_EQ(opacity(20, 15), 32);
    EXPECT_EQ(opacity(22, 15), 255);
}

// Along the line from a pure pixel to a mixed one both colour and opacity are interpolated.
TEST(PhotographOpacity, WhatCountsIsMixedByNoMoreThanAThird) {
    const GrayImage opacity = photograph_opacity(view_of_an_edge(), kDisparity_px);
    for (const auto& [mixed, beside] : {std::pair{19, 18}, std::pair{20, 21}}) {
        EXPECT_GE(opacity(beside, 15), 255 * kLeastCounting);
        const double third = (opacity(mixed, 15) + 2.0 * opacity(beside, 15)) / 3;
        EXPECT_LT(third, 255 * kLeastCounting);
    }
}

TEST(PhotographOpacity, DepthCoarserThanThePhotographMixesOnePixelBesideItsSamples) {
    LumigraphView view = view_of_an_edge();
    view.depth = {FloatImage(20, 15, 0.1F), GrayImage(20, 15, 255)};
    for (int y = 0; y < 15; ++y)
        for (int x = 0; x < 10; ++x) view.depth.inverse_depth(x, y) = 0.5F;
    const GrayImage opacity = photograph_opacity(view, kDisparity_px);
    EXPECT_EQ(opacity(16, 15), 255);
    EXPECT_EQ(opacity(17, 15), 77);
    EXPECT_EQ(opacity(18, 15), 32);
    EXPECT_EQ(opacity(21, 15), 32);
    EXPECT_EQ(opacity(22, 15), 77);
    EXPECT_EQ(opacity(23, 15), 255);
}

TEST(PhotographOpacity, AnEdgeThatThePhotographDoesNotShowMixesNothing) {
    LumigraphView view = view_of_an_edge();
    view.photograph = ColorImage(40, 30, {30, 30, 30});
    EXPECT_EQ(photograph_opacity(view, kDisparity_px)(20, 15), 255);
}

TEST(PhotographOpacity, NothingCountsNothing) {
    const GrayImage opacity = photograph_opacity(view_of_an_edge(), kDisparity_px);
    for (const std::uint8_t value : opacity.pixels()) EXPECT_GT(value, 0);
}

}  // namespace
}  // namespace lumi
