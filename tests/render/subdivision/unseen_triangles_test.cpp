#include "render/subdivision/unseen_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "render/reference/triangle_reference.h"
#include "render/subdivision/adaptive_subdivision.h"
#include "render/transfer/scene_plane.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr int kWideView = 3;

/// The eye stands back: through the face of three cameras with narrow photographs it sees more of
/// the wall than they do. The fourth camera sees nearly all of it, but for what the card hides.
class UnseenTriangles : public testing::Test {
 protected:
    void SetUp() override {
        std::erase_if(polygons_, [](const FacePolygon& polygon) {
            return std::count(polygon.view_indices.begin(), polygon.view_indices.end(), kWideView) >
                   0;
        });
        triangles_ = subdivided({.max_edge_px = 4});
    }

    [[nodiscard]] BlendTriangles subdivided(const AdaptiveSubdivisionOptions& options) const {
        return adaptive_subdivision(polygons_, search_, plane_, {}, options).triangles;
    }

    void draw_unseen_triangles() { draw_unseen(lumigraph_, eye_, search_, plane_, {}, triangles_); }

    /// Corners that show nothing, because no photograph has a weight.
    [[nodiscard]] std::size_t empty_corners() const {
        return static_cast<std::size_t>(std::count_if(
            triangles_.indices.begin(), triangles_.indices.end(), [&](std::uint32_t at) {
                return triangles_.vertices[at].weights == std::array<float, 3>{};
            }));
    }

    [[nodiscard]] bool is_seen_by_the_wide_view(const BlendVertex& at) const {
        const Eigen::Vector2d pixel(static_cast<double>(at.pixel[0]),
                                    static_cast<double>(at.pixel[1]));
        return search_.first_hit(pixel, {kWideView, kWideView, kWideView}).has_value();
    }

    [[nodiscard]] BlendTriangles from_the_wide_view() const {
        BlendTriangles taken = triangles_;
        taken.indices.clear();
        for (std::size_t i = 0; i < triangles_.indices.size(); i += 3)
            if (corner(i).view_layers[0] == static_cast<float>(kWideView))
                for (std::size_t k = i; k < i + 3; ++k)
                    taken.indices.push_back(triangles_.indices[k]);
        return taken;
    }

    [[nodiscard]] const BlendVertex& corner(std::size_t index) const {
        return triangles_.vertices[triangles_.indices[index]];
    }

    Camera narrow_ = pinhole_camera(64, 48, 200);
    Lumigraph lumigraph_ = photographed(
        AnalyticScene::kCardBeforeWall,
        {eye_at({-0.4, 0.2, 0}, {-0.4, 0.2, 4}, narrow_),
         eye_at({0.4, 0.2, 0}, {0.4, 0.2, 4}, narrow_), eye_at({0, -0.5, 0}, {0, -0.5, 4}, narrow_),
         eye_at({0, 0.9, 0}, {0, 0, 4}, pinhole_camera(192, 144, 120))});
    Eye eye_ = eye_at({0, 0, -1}, {0, 0, 4}, pinhole_camera(96, 72, 90));
    SearchedViews views_ = searched_views(lumigraph_);
    DepthSearch search_{lumigraph_, views_, eye_};
    Eigen::Vector3d plane_ = scene_plane_inverse_depth(lumigraph_, eye_);
    std::vector<FacePolygon> polygons_ = face_polygons(lumigraph_.mesh, eye_);
    BlendTriangles triangles_;
};

TEST_F(UnseenTriangles, ComeFromTheViewThatSeesThem) {
    const std::size_t count = triangles_.count();
    ASSERT_GT(empty_corners(), count / 2);
    draw_unseen_triangles();
    EXPECT_EQ(triangles_.count(), count);
    std::size_t seen = 0;
    std::size_t empty = 0;
    for (std::size_t i = 0; i < triangles_.indices.size(); i += 3) {
        if (!is_seen_by_the_wide_view(corner(i)) || !is_seen_by_the_wide_view(corner(i + 1)) ||
            !is_seen_by_the_wide_view(corner(i + 2)))
            continue;
        ++seen;
        if (corner(i).weights == std::array<float, 3>{}) ++empty;
    }
    EXPECT_GT(seen, count / 2);
    // Over the card's outline.
    EXPECT_LT(empty, seen / 50);
    const Frame drawn = draw_reference(triangles_, lumigraph_, eye_, PlaceInterpolation::kLinear);
    const ColorImage ideal = ideal_photograph(AnalyticScene::kCardBeforeWall, eye_);
    double difference = 0;
    int known = 0;
    for (std::size_t i = 0; i < ideal.pixels().size(); ++i) {
        if (drawn.coverage.pixels()[i] == 0) continue;
        difference += std::abs(drawn.color.pixels()[i].g - ideal.pixels()[i].g);
        ++known;
    }
    ASSERT_GT(known, 500);
    // Most of it from triangles over the card's outline.
    EXPECT_LT(difference / known, 5.0);
}

// Large triangles of the wall: in the wide view's photograph the card may stand before one, and
// hide none of its corners.
TEST_F(UnseenTriangles, DoNotShowWhatHidesThem) {
    triangles_ = subdivided({.min_edge_px = 64, .max_edge_px = 24});
    draw_unseen_triangles();
    const Frame drawn =
        draw_reference(from_the_wide_view(), lumigraph_, eye_, PlaceInterpolation::kLinear);
    const ColorImage ideal = ideal_photograph(AnalyticScene::kCardBeforeWall, eye_);
    int known = 0;
    int of_another_surface = 0;
    for (std::size_t i = 0; i < ideal.pixels().size(); ++i) {
        if (drawn.coverage.pixels()[i] == 0) continue;
        ++known;
        if (std::abs(drawn.color.pixels()[i].g - ideal.pixels()[i].g) > 40) ++of_another_surface;
    }
    EXPECT_GT(known, 2000);
    EXPECT_LT(of_another_surface, 50);
}

TEST_F(UnseenTriangles, AreNotGuessedFromOtherViews) {
    draw_unseen_triangles();
    const BlendTriangles taken = from_the_wide_view();
    EXPECT_GT(taken.count(), 0U);
    for (const std::uint32_t at : taken.indices) EXPECT_GT(taken.vertices[at].confidence, 0.0F);
}

TEST_F(UnseenTriangles, AreTheOnlyOnesThatChange) {
    const std::vector<std::uint32_t> before = triangles_.indices;
    std::vector<bool> are_seen;
    for (std::size_t i = 0; i < before.size(); ++i)
        are_seen.push_back(triangles_.vertices[before[i]].confidence > 0);
    draw_unseen_triangles();
    std::size_t seen = 0;
    for (std::size_t i = 0; i < before.size(); i += 3) {
        if (!are_seen[i] || !are_seen[i + 1] || !are_seen[i + 2]) continue;
        ++seen;
        for (std::size_t k = i; k < i + 3; ++k) EXPECT_EQ(triangles_.indices[k], before[k]);
    }
    EXPECT_GT(seen, 0U);
}

}  // namespace
}  // namespace lumi
