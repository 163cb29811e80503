#include "render/subdivision/own_surfaces.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>

#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr float kGuess = 0.25F;
constexpr float kSeen = 1.0F;
constexpr float kOnCard = 1.0F / 3;
constexpr float kOnWall = 1.0F / 6;

/// A small triangle: two corners at the card's depth in photograph 0, one at the wall's in
/// photograph 1.
class OwnSurfaces : public testing::Test {
 protected:
    [[nodiscard]] BlendVertex corner(double x, double y, std::size_t photograph,
                                     float inverse_depth, float confidence) const {
        BlendVertex made;
        made.pixel = {static_cast<float>(x), static_cast<float>(y)};
        made.view_layers = {0, 1, 2};
        made.inverse_depth = inverse_depth;
        made.confidence = confidence;
        made.weights[photograph] = 1;
        for (int view = 0; view < 3; ++view)
            made.view_pixels[static_cast<std::size_t>(view)] =
                place_in(view, {x, y}, inverse_depth);
        return made;
    }

    [[nodiscard]] BlendTriangles between_two_surfaces(float confidence, double edge_px) const {
        return {{corner(32, 24, 0, kOnCard, confidence),
                 corner(32 + edge_px, 24, 0, kOnCard, confidence),
                 corner(32, 24 + edge_px, 1, kOnWall, confidence)},
                {0, 1, 2}};
    }

    [[nodiscard]] std::array<float, 2> place_in(int view, const Eigen::Vector2d& pixel,
                                                float inverse_depth) const {
        const Eigen::Vector2d place =
            search_.line_in(view, pixel).at(static_cast<double>(inverse_depth))->pixel;
        return {static_cast<float>(place.x()), static_cast<float>(place.y())};
    }

    [[nodiscard]] static bool is_unchanged(const BlendTriangles& before,
                                           const BlendTriangles& after) {
        return before.indices == after.indices &&
               std::equal(before.vertices.begin(), before.vertices.end(), after.vertices.begin(),
                          after.vertices.end(), [](const BlendVertex& a, const BlendVertex& b) {
                              return a.pixel == b.pixel && a.view_pixels == b.view_pixels &&
                                     a.weights == b.weights && a.inverse_depth == b.inverse_depth &&
                                     a.confidence == b.confidence;
                          });
    }

    Lumigraph lumigraph_ = card_before_wall();
    SearchedViews views_ = searched_views(lumigraph_);
    Eye eye_ = eye_at({0.6, 0.4, 0}, {0.6, 0.4, 4}, pinhole_camera(64, 48, 80));
    DepthSearch search_{lumigraph_, views_, eye_};
};

TEST_F(OwnSurfaces, APhotographThatIsHiddenAtACornerStaysOnTheSurfaceThatItShows) {
    BlendTriangles triangles = between_two_surfaces(kGuess, 2);
    keep_own_surfaces(search_, triangles);
    ASSERT_EQ(triangles.count(), 1U);
    const BlendVertex& hidden = triangles.vertices[triangles.indices[2]];
    EXPECT_EQ(hidden.view_pixels[0], place_in(0, {32, 26}, kOnCard));
    EXPECT_EQ(hidden.view_pixels[1], place_in(1, {32, 26}, kOnWall));
    for (std::size_t c = 0; c < 2; ++c) {
        const BlendVertex& shown = triangles.vertices[triangles.indices[c]];
        const Eigen::Vector2d pixel(32 + 2.0 * static_cast<double>(c), 24);
        EXPECT_EQ(shown.view_pixels[0], place_in(0, pixel, kOnCard));
        EXPECT_EQ(shown.view_pixels[1], place_in(1, pixel, kOnWall));
    }
}

TEST_F(OwnSurfaces, OnlyTheTriangleItselfGetsAnotherCorner) {
    BlendTriangles triangles = between_two_surfaces(kGuess, 2);
    triangles.vertices.push_back(corner(34, 26, 1, kOnWall, kSeen));
    triangles.vertices.push_back(corner(36, 24, 1, kOnWall, kSeen));
    triangles.indices.insert(triangles.indices.end(), {2, 3, 4});
    keep_own_surfaces(search_, triangles);
    EXPECT_NE(triangles.indices[2], 2U);
    EXPECT_EQ(triangles.indices[3], 2U);
    EXPECT_EQ(triangles.vertices[2].view_pixels[0], place_in(0, {32, 26}, kOnWall));
}

TEST_F(OwnSurfaces, WhatIsSeenIsNotChanged) {
    const BlendTriangles before = between_two_surfaces(kSeen, 2);
    BlendTriangles after = before;
    keep_own_surfaces(search_, after);
    EXPECT_TRUE(is_unchanged(before, after));
}

TEST_F(OwnSurfaces, APhotographThatIsHardlySweptIsNotChanged) {
    const BlendTriangles before = between_two_surfaces(kGuess, 30);
    BlendTriangles after = before;
    keep_own_surfaces(search_, after);
    EXPECT_TRUE(is_unchanged(before, after));
}

// The mesh of cameras in a line names one of them twice.
TEST_F(OwnSurfaces, APhotographNamedTwiceCountsWhereEitherOfItsNamesDoes) {
    BlendTriangles before = between_two_surfaces(kGuess, 2);
    for (BlendVertex& made : before.vertices) {
        made.view_layers[2] = made.view_layers[0];
        made.view_pixels[2] = made.view_pixels[0];
    }
    before.vertices[0].weights = {0.5F, 0.5F, 0};
    before.vertices[1].weights = {0.5F, 0.5F, 0};
    before.vertices[2].weights = {0, 0.5F, 0.5F};
    BlendTriangles after = before;
    keep_own_surfaces(search_, after);
    EXPECT_TRUE(is_unchanged(before, after));
}

}  // namespace
}  // namespace lumi
