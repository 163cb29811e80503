#include "render/uploaded/photograph_opacity.h"

#include <gtest/gtest.h>

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

/// 40 x 30 pixels, near and bright below a diagonal, far and dark above it.
LumigraphView view_of_a_diagonal() {
    LumigraphView view = view_of_an_edge();
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            const bool is_near = x < y + 5;
            view.photograph(x, y) = is_near ? Rgb8{200, 200, 200} : Rgb8{30, 30, 30};
            view.depth.inverse_depth(x, y) = is_near ? 0.5F : 0.1F;
        }
    }
    return view;
}

// Between four pixels both colour and opacity are interpolated.
TEST(PhotographOpacity, WhatCountsIsMixedByNoMoreThanAThird) {
    for (const LumigraphView& view : {view_of_an_edge(), view_of_a_diagonal()}) {
        const GrayImage opacity = photograph_opacity(view, kDisparity_px);
        const auto is_mixed = [&](int x, int y) { return opacity(x, y) == 32 ? 1.0 : 0.0; };
        for (int y = 8; y < 21; ++y) {
            for (int x = 8; x < 31; ++x) {
                for (double v = 0; v <= 1; v += 0.1) {
                    for (double u = 0; u <= 1; u += 0.1) {
                        const auto between = [&](const auto& at) {
                            return (1 - v) * ((1 - u) * at(x, y) + u * at(x + 1, y)) +
                                   v * ((1 - u) * at(x, y + 1) + u * at(x + 1, y + 1));
                        };
                        if (between(opacity) < 255 * kLeastCounting) continue;
                        EXPECT_LE(between(is_mixed), 1.0 / 3) << x << ' ' << y;
                    }
                }
            }
        }
    }
}

TEST(PhotographOpacity, PurePixelsAreCoveredThemselvesNextToMixedOnes) {
    const GrayImage opacity = photograph_opacity(view_of_an_edge(), kDisparity_px);
    EXPECT_GE(opacity(18, 15), 255 * kLeastCounting);
    EXPECT_GE(opacity(21, 15), 255 * kLeastCounting);
}

TEST(PhotographOpacity, OnePixelBesideCoarseMixedSamplesCountsLess) {
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
