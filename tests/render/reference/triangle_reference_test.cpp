#include "render/reference/triangle_reference.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

// Both diagonals and both middle lines of the picture run through the middles of pixels.
TEST(TriangleReference, DrawsPixelsOnSharedEdgesOnce) {
    const Camera camera = pinhole_camera(9, 9, 10);
    Lumigraph lumigraph;
    LumigraphView& view = lumigraph.views.emplace_back();
    view.camera = camera;
    view.photograph = ColorImage(9, 9, {200, 100, 50});
    BlendTriangles triangles;
    const auto add_corner = [&](float x, float y) {
        BlendVertex& corner = triangles.vertices.emplace_back();
        corner.pixel = {x, y};
        corner.depth = 1;
        corner.view_pixels[0] = {4.5F, 4.5F};
        corner.depth_ratios[0] = 1;
        corner.weights[0] = 1;
        corner.opacity = 0.5F;
    };
    add_corner(4.5F, 4.5F);
    for (const auto& [x, y] : {std::pair{0.0F, 0.0F},
                               {4.5F, 0.0F},
                               {9.0F, 0.0F},
                               {9.0F, 4.5F},
                               {9.0F, 9.0F},
                               {4.5F, 9.0F},
                               {0.0F, 9.0F},
                               {0.0F, 4.5F}})
        add_corner(x, y);
    for (std::uint32_t i = 1; i <= 8; ++i)
        triangles.indices.insert(triangles.indices.end(), {0U, i, i % 8 + 1});
    const Frame drawn =
        draw_reference(triangles, lumigraph, {camera, {}}, PlaceInterpolation::kProjective);
    for (const Rgb8& color : drawn.color.pixels()) EXPECT_EQ(color, (Rgb8{100, 50, 25}));
}

TEST(TriangleReference, LooksNothingUpInAPhotographThatHasNoPlaceForACorner) {
    const Camera camera = pinhole_camera(9, 9, 10);
    Lumigraph lumigraph;
    BlendTriangles triangles;
    for (int view = 0; view < 2; ++view) {
        lumigraph.views.emplace_back().camera = camera;
        lumigraph.views.back().photograph = ColorImage(9, 9, {200, 100, 50});
    }
    for (const auto& [x, y] : {std::pair{-9.0F, -9.0F}, {30.0F, -9.0F}, {-9.0F, 30.0F}}) {
        BlendVertex& corner = triangles.vertices.emplace_back();
        corner.pixel = {x, y};
        corner.depth = 1;
        corner.view_layers = {0, 1, 1};
        // Infinitely far to one side or the other.
        const float far = x * std::numeric_limits<float>::infinity();
        corner.view_pixels = {{{4.5F, 4.5F}, {far, 4.5F}, {}}};
        corner.depth_ratios = {1, 0, 0};
        corner.weights = {1, 0, 0};
        corner.opacity = 1;
        triangles.indices.push_back(static_cast<std::uint32_t>(triangles.indices.size()));
    }
    // Where it counts at other corners it is looked up by these, or not at all.
    for (const float weight : {0.0F, 0.4F})
        for (const auto places : {PlaceInterpolation::kLinear, PlaceInterpolation::kProjective}) {
            triangles.vertices[1].weights = {1 - weight, weight, 0};
            triangles.vertices[1].view_pixels[1] = {4.5F, 4.5F};
            triangles.vertices[1].depth_ratios[1] = weight;
            const Frame drawn = draw_reference(triangles, lumigraph, {camera, {}}, places);
            for (const Rgb8& color : drawn.color.pixels()) EXPECT_EQ(color, (Rgb8{200, 100, 50}));
        }
}

}  // namespace
}  // namespace lumi
