#include "pipeline/bench/shown_pixels.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

constexpr int kSize = 64;
constexpr int kBarBegin = 28;  // Columns of the view that a bar at z = 2 fills.
constexpr int kBarEnd = 36;
constexpr double kStep = 1;  // The eye's, to the right: 16 px at the wall, 32 px at the bar.

Camera camera() { return pinhole_camera(kSize, kSize, 64); }

Eye eye() { return {camera(), {Eigen::Quaterniond::Identity(), {-kStep, 0, 0}}}; }

/// A view at the origin of a bar before what lies at this inverse depth.
std::vector<LumigraphView> bar_before(float background) {
    LumigraphView view;
    view.camera = camera();
    view.depth = {FloatImage(kSize, kSize, background), GrayImage(kSize, kSize, 255)};
    for (int y = 0; y < kSize; ++y)
        for (int x = kBarBegin; x < kBarEnd; ++x) view.depth.inverse_depth(x, y) = 0.5F;
    return {view};
}

TEST(ShownPixels, AreThoseThatNothingHidesFromTheView) {
    const FloatImage wall(kSize, kSize, 4.0F);
    const GrayImage shown = shown_pixels(wall, eye(), bar_before(0.25F));
    for (int x = 1; x < kSize; ++x) {
        const int in_view = x + 16;
        const bool is_inside = in_view < kSize - 1;
        const bool is_by_the_bar = in_view >= kBarBegin - 1 && in_view <= kBarEnd;
        EXPECT_EQ(shown(x, 20) != 0, is_inside && !is_by_the_bar) << x;
    }
}

TEST(ShownPixels, AreNotThoseOfASurfaceThatTheViewDoesNotHave) {
    const FloatImage nearer(kSize, kSize, 3.5F);
    const GrayImage shown = shown_pixels(nearer, eye(), bar_before(0.25F));
    for (const std::uint8_t pixel : shown.pixels()) EXPECT_EQ(pixel, 0);
}

TEST(ShownPixels, AreThoseOfNothingWhereTheSameDirectionShowsNothing) {
    const FloatImage nothing(kSize, kSize, 0.0F);
    const GrayImage shown = shown_pixels(nothing, eye(), bar_before(0.0F));
    EXPECT_NE(shown(10, 20), 0);
    EXPECT_EQ(shown(kBarBegin + 2, 20), 0);
}

}  // namespace
}  // namespace lumi
