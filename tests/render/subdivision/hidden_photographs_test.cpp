#include "render/subdivision/hidden_photographs.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "render/depth_search/occlusion.h"
#include "render/subdivision/adaptive_subdivision.h"
#include "render/transfer/scene_plane.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr double kHiddenFocal_px = 260.0;
constexpr double kCardDepth = 3.0;
constexpr double kWallDepth = 6.0;

Eye facing_wall(double x, double y) {
    return eye_at({x, y, 0}, {x, y, 6}, pinhole_camera(256, 192, kHiddenFocal_px));
}

/// An eye amid four cameras before a card that hides another part of the wall from each of them.
class HiddenPhotographs : public testing::Test {
 protected:
    [[nodiscard]] Eigen::Vector2d on_wall(const Eigen::Vector2d& pixel) const {
        return kWallDepth / kHiddenFocal_px * (pixel - Eigen::Vector2d(128, 96));
    }

    /// Where the camera of a view meets the card's plane on its way to what the eye sees of the
    /// wall at a pixel: how far within the card's outline, below 0 beside it.
    [[nodiscard]] double within_card(const Eigen::Vector2d& pixel, int view) const {
        const Eigen::Vector3d camera =
            centre_in_world(scene_.views[static_cast<std::size_t>(view)].cam_from_world);
        const Eigen::Vector2d at_card = 0.5 * (on_wall(pixel) + camera.head<2>());
        return std::min(0.7 - std::abs(at_card.x()), 0.5 - std::abs(at_card.y()));
    }

    [[nodiscard]] bool is_wall(const BlendVertex& corner) const {
        return std::abs(static_cast<double>(corner.inverse_depth) - 1 / kWallDepth) < 0.01;
    }

    Eye eye_ = facing_wall(0, 0);
    std::vector<Eye> cameras_{facing_wall(0.4, 0.3), facing_wall(-0.4, 0.3),
                              facing_wall(-0.4, -0.3), facing_wall(0.4, -0.3)};
    Lumigraph scene_ = photographed(AnalyticScene::kCardBeforeWall, cameras_);
    SearchedViews views_ = searched_views(scene_);
    DepthSearch search_{scene_, views_, eye_};
    Eigen::Vector3d plane_ = scene_plane_inverse_depth(scene_, eye_);
    std::vector<FacePolygon> polygons_ = face_polygons(scene_.mesh, eye_);
};

TEST_F(HiddenPhotographs, AreBlendedInNoTriangleOfWhichTheyLoseACornerWhileAnotherSeesAll) {
    const BlendTriangles triangles =
        adaptive_subdivision(polygons_, search_, plane_, {}, {.min_edge_px = 12}).triangles;
    constexpr double kSample = 2 * kCardDepth / kHiddenFocal_px;
    int lost = 0;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        std::array<const BlendVertex*, 3> corners{};
        for (std::size_t c = 0; c < 3; ++c)
            corners[c] = &triangles.vertices[triangles.indices[i + c]];
        const auto at_all = [&](const auto& holds) {
            return std::all_of(corners.begin(), corners.end(), holds);
        };
        const auto at_any = [&](const auto& holds) {
            return std::any_of(corners.begin(), corners.end(), holds);
        };
        if (!at_all([&](const BlendVertex* corner) { return is_wall(*corner); })) continue;
        bool does_one_see_all = false;
        for (std::size_t k = 0; k < 3; ++k)
            if (at_all([&](const BlendVertex* corner) { return corner->weights[k] > 0; }))
                does_one_see_all = true;
        if (!does_one_see_all) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto view = static_cast<int>(corners[0]->view_layers[k]);
            const auto depth_in_card = [&](const BlendVertex* corner) {
                return within_card(vector_of(corner->pixel), view);
            };
            const bool is_lost = at_any([&](const BlendVertex* corner) {
                return depth_in_card(corner) > kSample && corner->occluded > 0.02F;
            });
            const bool is_seen =
                at_any([&](const BlendVertex* corner) { return depth_in_card(corner) < -kSample; });
            if (!is_lost || !is_seen) continue;
            ++lost;
            EXPECT_TRUE(at_all([&](const BlendVertex* corner) { return corner->weights[k] <= 0; }))
                << "view " << view << " around " << vector_of(corners[0]->pixel).transpose();
        }
    }
    EXPECT_GT(lost, 10);
}

TEST_F(HiddenPhotographs, LeaveOthersTheirRatio) {
    BlendVertex corner;
    corner.weights = {0.5F, 0.3F, 0.2F};
    const BlendVertex left = without({false, false, true}, corner);
    EXPECT_FLOAT_EQ(left.weights[0], 0.625F);
    EXPECT_FLOAT_EQ(left.weights[1], 0.375F);
    EXPECT_EQ(left.weights[2], 0.0F);
    EXPECT_EQ(without({false, true, true}, corner).weights, (std::array<float, 3>{1, 0, 0}));
    EXPECT_EQ(without({}, corner).weights, corner.weights);
}

/// A triangle of one polygon with corners at these pixels.
struct LookedUp {
    LookedUp(const PatchSampler& sampler, const std::vector<Eigen::Vector2d>& pixels) {
        for (std::size_t c = 0; c < 3; ++c)
            vertices[c] =
                blend_vertex(sampler.at(pixels[c]), sampler.polygon(), VertexDepth::kAffine);
    }
    [[nodiscard]] std::array<const BlendVertex*, 3> corners() const {
        return {&vertices[0], &vertices[1], &vertices[2]};
    }
    std::array<BlendVertex, 3> vertices;
};

TEST_F(HiddenPhotographs, AreNoneWhereAllSeeAllOrNoOtherDoes) {
    int alone = 0;
    for (const FacePolygon& polygon : polygons_) {
        const PatchSampler sampler(polygon, search_, plane_, {});
        Eigen::Vector2d middle(0, 0);
        for (const Eigen::Vector2d& corner : polygon.corners_px)
            middle += corner / static_cast<double>(polygon.corners_px.size());
        LookedUp seen(sampler,
                      {middle, middle + Eigen::Vector2d(2, 0), middle + Eigen::Vector2d(0, 2)});
        for (BlendVertex& corner : seen.vertices) corner.weights = {0.5F, 0.25F, 0.25F};
        EXPECT_EQ(hidden_photographs(sampler, seen.corners()), (std::array<bool, 3>{}));
        // Each photograph is lost at one of the corners: none could stand in for the others.
        for (std::size_t c = 0; c < 3; ++c) {
            seen.vertices[c].weights = {0.5F, 0.5F, 0.5F};
            seen.vertices[c].weights[c] = 0;
        }
        EXPECT_EQ(hidden_photographs(sampler, seen.corners()), (std::array<bool, 3>{}));
        ++alone;
    }
    EXPECT_GT(alone, 0);
}

TEST_F(HiddenPhotographs, AreNoneWhereAPhotographWouldNotCountAnyway) {
    // At a camera's own place in the mesh the others have no weight, hidden or not.
    const Eye at_camera = cameras_[0];
    const DepthSearch search(scene_, views_, at_camera);
    for (const FacePolygon& polygon : face_polygons(scene_.mesh, at_camera)) {
        const PatchSampler sampler(polygon, search, plane_, {});
        for (double x = 4; x < 250; x += 16) {
            const LookedUp triangle(sampler, {{x, 20}, {x + 12, 20}, {x, 32}});
            EXPECT_EQ(hidden_photographs(sampler, triangle.corners()), (std::array<bool, 3>{}));
        }
    }
}

TEST_F(HiddenPhotographs, AreNotHiddenByGuesses) {
    Lumigraph guessed = scene_;
    for (LumigraphView& view : guessed.views)
        for (std::uint8_t& confidence : view.depth.confidence.pixels()) confidence = 0;
    const SearchedViews views = searched_views(guessed);
    const DepthSearch search(guessed, views, eye_);
    int hidden = 0;
    for (double x = 4; x < 256; x += 8) {
        EXPECT_EQ(search.hidden_by_px({x, 96}, 1 / kWallDepth, 0), 0.0);
        if (search_.hidden_by_px({x, 96}, 1 / kWallDepth, 0) > 0) ++hidden;
    }
    EXPECT_GT(hidden, 4);
}

TEST_F(HiddenPhotographs, LieBehindWhatIsAsManyPixelsBeforeThemAsItsDepthSays) {
    // The median neighbour of a corner of the rectangle is nearer than the eye.
    const double baseline = std::min(0.5, view_geometries(scene_)[0].baseline);
    const double expected_px = kHiddenFocal_px * baseline * (1 / kCardDepth - 1 / kWallDepth);
    int hidden = 0;
    int seen = 0;
    for (int view = 0; view < 4; ++view) {
        for (double x = 4; x < 256; x += 8) {
            for (double y = 4; y < 192; y += 8) {
                const double within = within_card({x, y}, view);
                if (std::abs(within) < 0.04) continue;
                const Eigen::Vector2d in_view =
                    search_.line_in(view, {x, y}).at(1 / kWallDepth)->pixel;
                const bool is_shown =
                    in_view.x() > 1 && in_view.y() > 1 && in_view.x() < 255 && in_view.y() < 191;
                if (!is_shown) continue;
                ++(within > 0 ? hidden : seen);
                EXPECT_NEAR(search_.hidden_by_px({x, y}, 1 / kWallDepth, view),
                            within > 0 ? expected_px : 0.0, 0.01)
                    << x << ' ' << y << " view " << view;
            }
        }
        EXPECT_EQ(search_.hidden_by_px({1e4, 96}, 1 / kWallDepth, view), 0.0);
        EXPECT_EQ(search_.hidden_by_px({128, 96}, 1.0, view), 0.0) << "the card is behind that";
    }
    EXPECT_GT(hidden, 100);
    EXPECT_GT(seen, 100);
}

/// A triangle of the wall, all of whose corners each photograph sees, and in one of them a bar
/// stands between: of photographs that see thin things that one is left out.
TEST_F(HiddenPhotographs, ShowNothingThinBetweenCorners) {
    int left_out = 0;
    for (const bool draws_thin : {true, false}) {
        Lumigraph bar = photographed(AnalyticScene::kBarBeforeWall, cameras_);
        bar.drawing.draws_thin = draws_thin;
        const SearchedViews views = searched_views(bar);
        const DepthSearch search(bar, views, eye_);
        const Eigen::Vector3d plane = scene_plane_inverse_depth(bar, eye_);
        for (const FacePolygon& polygon : face_polygons(bar.mesh, eye_)) {
            const PatchSampler sampler(polygon, search, plane, {});
            for (double x = 16; x < 236; x += 4) {
                const LookedUp triangle(sampler, {{x, 60}, {x + 18, 60}, {x + 9, 90}});
                const bool is_free =
                    std::all_of(triangle.vertices.begin(), triangle.vertices.end(),
                                [&](const BlendVertex& corner) {
                                    return is_wall(corner) && corner.occluded < 0.001F;
                                });
                if (!is_free) continue;
                const std::array<bool, 3> hidden = hidden_photographs(sampler, triangle.corners());
                for (std::size_t k = 0; k < 3; ++k) {
                    if (!hidden[k]) continue;
                    ++left_out;
                    EXPECT_TRUE(draws_thin);
                    // Where the bar is in that photograph, at x = 128 less what its camera stands
                    // to the right.
                    const double bar_x =
                        128 - kHiddenFocal_px / kCardDepth *
                                  centre_in_world(
                                      bar.views[static_cast<std::size_t>(polygon.view_indices[k])]
                                          .cam_from_world)
                                      .x();
                    double least = 1e9;
                    double most = -1e9;
                    for (const BlendVertex& corner : triangle.vertices) {
                        least = std::min(least, static_cast<double>(corner.view_pixels[k][0]));
                        most = std::max(most, static_cast<double>(corner.view_pixels[k][0]));
                    }
                    EXPECT_LT(least, bar_x + 3);
                    EXPECT_GT(most, bar_x - 3);
                }
            }
        }
    }
    EXPECT_GT(left_out, 2);
}

/// Around the ball no camera nearby has seen the sky: the ball is before it.
TEST(Guesses, ShowNothingThatStandsBeforeThem) {
    const Lumigraph scene = ball_in_sky();
    const SearchedViews views = searched_views(scene);
    const Eye eye = eye_at({1, -2, -3}, {0, 0, 0}, pinhole_camera(80, 60, 90));
    const DepthSearch search(scene, views, eye);
    const Eigen::Vector3d plane = scene_plane_inverse_depth(scene, eye);
    int hidden = 0;
    for (const FacePolygon& polygon : face_polygons(scene.mesh, eye)) {
        const PatchSampler sampler(polygon, search, plane, {});
        for (int y = 0; y < 60; ++y) {
            for (int x = 0; x < 80; ++x) {
                const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
                const PatchSample sample = sampler.at(pixel);
                if (sample.hits) continue;
                for (std::size_t k = 0; k < 3; ++k) {
                    if (search.hidden_by_px(pixel, sample.inverse_depth, polygon.view_indices[k]) <
                        kSurelyBefore_px)
                        continue;
                    ++hidden;
                    EXPECT_EQ(sample.weights[k], 0.0) << x << ' ' << y;
                }
            }
        }
    }
    EXPECT_GT(hidden, 100);
}

}  // namespace
}  // namespace lumi
