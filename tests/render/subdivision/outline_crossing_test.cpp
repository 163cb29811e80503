#include "render/subdivision/outline_crossing.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "render/transfer/scene_plane.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr double kFocal_px = 260.0;
constexpr float kCardInverseDepth = 1.0F / 3;
constexpr float kWallInverseDepth = 1.0F / 6;

Eye camera_at(double x, double y) {
    return eye_at({x, y, 0}, {x, y, 6}, pinhole_camera(256, 192, kFocal_px));
}

/// The whole picture through the first camera.
FacePolygon picture_through_first() {
    FacePolygon polygon;
    polygon.view_indices.fill(0);
    polygon.side_lines.fill({0, 0, 1});
    return polygon;
}

/// A card before a wall, seen by an eye through a camera that stands aside from it.
class ThroughCamera {
 public:
    ThroughCamera(const Eye& eye, double x, double y)
        : lumigraph_(photographed(
              AnalyticScene::kCardBeforeWall,
              {camera_at(x, y), camera_at(-x, y), camera_at(-x, -y), camera_at(x, -y)})),
          search_(lumigraph_, views_, eye),
          sampler_(polygon_, search_, scene_plane_inverse_depth(lumigraph_, eye), {}) {}

    [[nodiscard]] BlendVertex vertex_at(double x, double y) const {
        return blend_vertex(sampler_.at({x, y}), polygon_, VertexDepth::kAffine);
    }
    [[nodiscard]] std::optional<OutlineCrossing> crossing(const BlendVertex& from,
                                                          const BlendVertex& to) const {
        return outline_crossing(sampler_, from, to);
    }
    [[nodiscard]] Eigen::Vector2d looked_up(const Eigen::Vector2d& pixel,
                                            float inverse_depth) const {
        return search_.line_in(0, pixel).at(static_cast<double>(inverse_depth))->pixel;
    }

 private:
    Lumigraph lumigraph_;
    SearchedViews views_ = searched_views(lumigraph_);
    FacePolygon polygon_ = picture_through_first();
    DepthSearch search_;
    PatchSampler sampler_;
};

/// Of the card's right end in the eye's picture.
constexpr double kOutline_px = 128 + kFocal_px * 0.7 / 3;

class OutlineCrossingTest : public testing::Test {
 protected:
    ThroughCamera through_camera_{camera_at(0, 0), 0.4, 0.3};
};

TEST_F(OutlineCrossingTest, LiesOnTheOutlineOnceOnEitherSurface) {
    for (double before_px = 0.5; before_px < 12; before_px += 1) {
        const double from_px = kOutline_px - before_px;
        const auto crossing = through_camera_.crossing(through_camera_.vertex_at(from_px, 90),
                                                       through_camera_.vertex_at(from_px + 12, 96));
        ASSERT_TRUE(crossing) << before_px;
        const Eigen::Vector2d pixel = vector_of(crossing->at_from.pixel);
        EXPECT_EQ(crossing->at_from.pixel, crossing->at_to.pixel);
        // Half of what is left to halve, and a sample of depth.
        EXPECT_NEAR(pixel.x(), kOutline_px, 2.5) << before_px;
        EXPECT_NEAR(pixel.y(), 90 + 0.5 * (pixel.x() - from_px), 1e-4) << before_px;
        EXPECT_NEAR(crossing->at_from.inverse_depth, kCardInverseDepth, 1e-3F) << before_px;
        EXPECT_NEAR(crossing->at_to.inverse_depth, kWallInverseDepth, 1e-3F) << before_px;
        for (const BlendVertex& side : {crossing->at_from, crossing->at_to})
            EXPECT_LT((vector_of(side.view_pixels[0]) -
                       through_camera_.looked_up(pixel, side.inverse_depth))
                          .norm(),
                      1e-4)
                << before_px;
    }
}

TEST_F(OutlineCrossingTest, IsTheSameFromEitherEnd) {
    const BlendVertex on_card = through_camera_.vertex_at(kOutline_px - 8, 90);
    const BlendVertex on_wall = through_camera_.vertex_at(kOutline_px + 4, 90);
    const auto outwards = through_camera_.crossing(on_card, on_wall);
    const auto inwards = through_camera_.crossing(on_wall, on_card);
    ASSERT_TRUE(outwards && inwards);
    EXPECT_EQ(outwards->at_from.pixel, inwards->at_to.pixel);
    EXPECT_EQ(outwards->at_from.inverse_depth, inwards->at_to.inverse_depth);
    EXPECT_EQ(outwards->at_to.inverse_depth, inwards->at_from.inverse_depth);
}

// Between card and wall the photograph of a camera next to the eye is looked up two pixels apart.
TEST(OutlineCrossing, IsNotFoundWherePhotographsAreLookedUpNearlyAlike) {
    const ThroughCamera through_near(camera_at(0, 0), 0.04, 0.03);
    const BlendVertex on_card = through_near.vertex_at(kOutline_px - 6, 90);
    const BlendVertex on_wall = through_near.vertex_at(kOutline_px + 6, 90);
    EXPECT_NEAR(on_card.inverse_depth, kCardInverseDepth, 1e-3F);
    EXPECT_NEAR(on_wall.inverse_depth, kWallInverseDepth, 1e-3F);
    EXPECT_FALSE(through_near.crossing(on_card, on_wall));
}

// The wall from aside, above the card.
TEST(OutlineCrossing, IsNotFoundWhereDepthChangesBitByBit) {
    const Eye aslant = eye_at({-3, 2, 3}, {0, 2, 6}, pinhole_camera(256, 192, kFocal_px));
    const ThroughCamera through_camera(aslant, 0.4, 1.5);
    const BlendVertex nearer = through_camera.vertex_at(150, 96);
    const BlendVertex farther = through_camera.vertex_at(100, 96);
    const Eigen::Vector2d between(125, 96);
    EXPECT_GT(std::abs(nearer.inverse_depth - farther.inverse_depth), 0.01F);
    EXPECT_GT((through_camera.looked_up(between, nearer.inverse_depth) -
               through_camera.looked_up(between, farther.inverse_depth))
                  .norm(),
              8);
    EXPECT_FALSE(through_camera.crossing(nearer, farther));
}

}  // namespace
}  // namespace lumi
