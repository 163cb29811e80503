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
    EXPECT_EQ(opacity(18, 15), 255);
    EXPECT_EQ(opacity(19, 15), 32);
    EXPECT_EQ(opacity(20, 15), 32);
    EXPECT_EQ(opacity(21, 15), 255);
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
