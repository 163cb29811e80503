#include "render/uploaded/photograph_lod.h"

#include <gtest/gtest.h>

#include <utility>

#include "calib/capture/camera.h"

namespace lumi {
namespace {

constexpr double kFocalLength_px = 600;

/// For an eye at the only camera, whose pixels are so many of the photograph's wide.
double lod_at(double texels_per_pixel, double samples_across_pixel = 1.0) {
    Lumigraph lumigraph;
    lumigraph.mesh.scene_centre_in_world = {0, 0, 3};
    LumigraphView view;
    view.camera = pinhole_camera(640, 480, kFocalLength_px);
    lumigraph.views.push_back(std::move(view));
    const Eye eye{pinhole_camera(640, 480, kFocalLength_px / texels_per_pixel), {}};
    return photograph_lod(lumigraph, eye, samples_across_pixel);
}

TEST(PhotographLod, OneLevelIsLookedUpAloneWhereUpToTwoOfItsTexelsFallOnAPixel) {
    for (const double texels : {0.1, 0.7, 1.0, 1.5, 1.99}) EXPECT_EQ(lod_at(texels), 0.0) << texels;
    for (const double texels : {3.01, 3.5, 3.99}) EXPECT_EQ(lod_at(texels), 1.0) << texels;
    for (const double texels : {6.01, 7.0, 7.99}) EXPECT_EQ(lod_at(texels), 2.0) << texels;
}

TEST(PhotographLod, BetweenLevelsOneTakesOverWithoutAStep) {
    EXPECT_NEAR(lod_at(2 * 1.2247448714), 0.5, 1e-6);  // Half way from 2 to 3, of ratios.
    double before = 0;
    for (double texels = 0.5; texels < 40; texels *= 1.01) {
        const double lod = lod_at(texels);
        EXPECT_GE(lod, before) << texels;
        EXPECT_LE(lod, before + 0.03) << texels;
        before = lod;
    }
}

TEST(PhotographLod, SamplesOfAPixelAreLookedUpForAllOfIt) {
    EXPECT_DOUBLE_EQ(lod_at(1.2, 2.0), lod_at(2.4));
}

/// Cameras in a row before the scene, of alternating focal lengths in pixels.
Lumigraph row_of(int count, double first_px, double second_px) {
    Lumigraph lumigraph;
    lumigraph.mesh.scene_centre_in_world = {0, 0, 3};
    for (int i = 0; i < count; ++i) {
        LumigraphView view;
        view.camera = pinhole_camera(640, 480, i % 2 == 0 ? first_px : second_px);
        view.cam_from_world.translation = {-0.3 * (i - count / 2), 0, 0};
        lumigraph.views.push_back(std::move(view));
    }
    return lumigraph;
}

TEST(PhotographLod, AtAPhotographOfMixedSizesItIsTheFinest) {
    const Lumigraph lumigraph = row_of(9, 2400, 300);
    for (const LumigraphView& view : lumigraph.views)
        EXPECT_EQ(photograph_lod(lumigraph, {view.camera, view.cam_from_world}), 0.0)
            << focal_length_px(view.camera).x();
}

TEST(PhotographLod, BetweenPhotographsOfMixedSizesItIsOfTheirMean) {
    const Lumigraph lumigraph = row_of(8, 1200, 300);
    const Eye eye{pinhole_camera(640, 480, 600 / 3.5), {{}, {0.15, 0, 0}}};
    EXPECT_EQ(photograph_lod(lumigraph, eye), 1.0);
}

}  // namespace
}  // namespace lumi
