#include "render/subdivision/seen_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "render/modes/adaptive.h"
#include "render/reference/triangle_reference.h"
#include "render/subdivision/adaptive_subdivision.h"
#include "render/subdivision/unseen_triangles.h"
#include "render/transfer/scene_plane.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr int kWiderView = 3;

/// The eye stands back and sees more of the wall, and of the card before it, than the face's three
/// cameras do. A fourth camera sees more than they, and less than the eye: triangles lie across the
/// border of its photograph, and across the card's outline.
class SeenParts : public testing::Test {
 protected:
    void SetUp() override {
        std::erase_if(polygons_, [](const FacePolygon& polygon) {
            return std::count(polygon.view_indices.begin(), polygon.view_indices.end(),
                              kWiderView) > 0;
        });
        triangles_ = adaptive_subdivision(polygons_, search_, plane_, {},
                                          {.min_edge_px = 64, .max_edge_px = 24})
                         .triangles;
        partly_seen_ = draw_unseen(lumigraph_, eye_, search_, plane_, {}, triangles_);
    }

    [[nodiscard]] BlendTriangles parts(const SeenPartsOptions& options) const {
        return seen_parts(partly_seen_, triangles_.vertices, {search_, plane_, {}}, options);
    }

    [[nodiscard]] Frame drawn(const BlendTriangles& triangles) const {
        return draw_reference(triangles, lumigraph_, eye_, PlaceInterpolation::kLinear);
    }

    /// Of known pixels: those that show something else than is there.
    [[nodiscard]] std::pair<int, int> known_and_wrong(const Frame& frame) const {
        const ColorImage ideal = ideal_photograph(AnalyticScene::kCardBeforeWall, eye_);
        int known = 0;
        int wrong = 0;
        for (std::size_t i = 0; i < ideal.pixels().size(); ++i) {
            if (frame.coverage.pixels()[i] == 0) continue;
            ++known;
            if (std::abs(frame.color.pixels()[i].g - ideal.pixels()[i].g) > 40) ++wrong;
        }
        return {known, wrong};
    }

    static double longest_edge_px(const BlendTriangles& triangles, std::size_t first_index) {
        double longest = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto pixel = [&](std::size_t corner) {
                return vector_of(triangles.vertices[triangles.indices[first_index + corner]].pixel);
            };
            longest = std::max(longest, (pixel(k) - pixel((k + 1) % 3)).norm());
        }
        return longest;
    }

    [[nodiscard]] double longest_whole_px() const {
        double longest = 0;
        BlendTriangles wholes{triangles_.vertices, {}};
        for (const UnseenTriangle& triangle : partly_seen_)
            wholes.indices.insert(wholes.indices.end(), triangle.corners.begin(),
                                  triangle.corners.end());
        for (std::size_t i = 0; i < wholes.indices.size(); i += 3)
            longest = std::max(longest, longest_edge_px(wholes, i));
        return longest;
    }

    Camera narrow_ = pinhole_camera(64, 48, 200);
    Lumigraph lumigraph_ = photographed(
        AnalyticScene::kCardBeforeWall,
        {eye_at({-0.4, 0.2, 0}, {-0.4, 0.2, 4}, narrow_),
         eye_at({0.4, 0.2, 0}, {0.4, 0.2, 4}, narrow_), eye_at({0, -0.5, 0}, {0, -0.5, 4}, narrow_),
         eye_at({0, 0.9, 0}, {0, 0, 4}, pinhole_camera(96, 72, 100))});
    Eye eye_ = eye_at({0, 0, -1}, {0, 0, 4}, pinhole_camera(192, 144, 150));
    SearchedViews views_ = searched_views(lumigraph_);
    DepthSearch search_{lumigraph_, views_, eye_};
    Eigen::Vector3d plane_ = scene_plane_inverse_depth(lumigraph_, eye_);
    std::vector<FacePolygon> polygons_ = face_polygons(lumigraph_.mesh, eye_);
    BlendTriangles triangles_;
    std::vector<UnseenTriangle> partly_seen_;
};

TEST_F(SeenParts, ReachTheBorderOfWhatAnotherViewShows) {
    ASSERT_FALSE(partly_seen_.empty());
    const BlendTriangles fine = parts({.long_edge_px = 6});
    const auto [known, wrong] = known_and_wrong(drawn(fine));
    int seen = 0;
    for (const UnseenTriangle& triangle : partly_seen_) {
        BlendTriangles whole;
        for (const std::uint32_t corner : triangle.corners) {
            whole.indices.push_back(static_cast<std::uint32_t>(whole.vertices.size()));
            whole.vertices.push_back(triangles_.vertices[corner]);
            whole.vertices.back().weights = {1, 0, 0};
            whole.vertices.back().confidence = 1;
            whole.vertices.back().view_layers = {0, 0, 0};
            whole.vertices.back().view_pixels.fill({32, 24});
        }
        const Frame inside = drawn(whole);
        for (int y = 0; y < eye_.camera.height_px; ++y)
            for (int x = 0; x < eye_.camera.width_px; ++x)
                if (inside.coverage(x, y) > 0 &&
                    search_.first_hit({x + 0.5, y + 0.5}, {kWiderView, kWiderView, kWiderView}))
                    ++seen;
    }
    ASSERT_GT(seen, 1000);
    EXPECT_GT(known, seen * 7 / 10) << "of what the view sees of these triangles";
    EXPECT_LE(known, seen);
    EXPECT_LT(wrong, known / 50);
}

TEST_F(SeenParts, ShowMoreTheSmallerTheyMayBe) {
    int last = 0;
    for (const double long_edge_px : {24.0, 12.0, 6.0}) {
        const int known = known_and_wrong(drawn(parts({.long_edge_px = long_edge_px}))).first;
        EXPECT_GT(known, last) << long_edge_px;
        last = known;
    }
}

TEST_F(SeenParts, AreNoGuesses) {
    const BlendTriangles all = parts({.long_edge_px = 6});
    ASSERT_GT(all.count(), 0U);
    for (const std::uint32_t corner : all.indices) {
        EXPECT_GT(all.vertices[corner].confidence, 0.0F);
        EXPECT_EQ(all.vertices[corner].view_layers[0], static_cast<float>(kWiderView));
    }
}

TEST_F(SeenParts, AreQuartersAndQuartersOfQuarters) {
    const BlendTriangles all = parts({.long_edge_px = 10});
    ASSERT_GT(all.count(), 0U);
    double shortest = longest_whole_px();
    for (std::size_t i = 0; i < all.indices.size(); i += 3) {
        EXPECT_LE(longest_edge_px(all, i), longest_whole_px() / 2 + 1e-3);
        EXPECT_GE(longest_edge_px(all, i), 5.0 - 1e-3);
        shortest = std::min(shortest, longest_edge_px(all, i));
    }
    EXPECT_LE(shortest, longest_whole_px() / 4);
}

TEST_F(SeenParts, KeepToTheirNumberAndAreTheLeastDivided) {
    const BlendTriangles all = parts({.long_edge_px = 6});
    ASSERT_GT(all.count(), 20U);
    const BlendTriangles few = parts({.long_edge_px = 6, .max_parts = 20});
    EXPECT_EQ(few.count(), 20U);
    double shortest = longest_whole_px();
    for (std::size_t i = 0; i < few.indices.size(); i += 3)
        shortest = std::min(shortest, longest_edge_px(few, i));
    double shortest_of_all = longest_whole_px();
    for (std::size_t i = 0; i < all.indices.size(); i += 3)
        shortest_of_all = std::min(shortest_of_all, longest_edge_px(all, i));
    EXPECT_GT(shortest, shortest_of_all);
}

TEST_F(SeenParts, AreNoneOfTrianglesThatMayNotBeDivided) {
    EXPECT_EQ(parts({.long_edge_px = 1.001 * longest_whole_px()}).count(), 0U);
    EXPECT_EQ(seen_parts({}, triangles_.vertices, {search_, plane_, {}}, {}).count(), 0U);
}

std::size_t count_of(const std::vector<BlendTriangles>& layers) {
    std::size_t count = 0;
    for (const BlendTriangles& layer : layers) count += layer.count();
    return count;
}

TEST_F(SeenParts, AreLaidOverTheTrianglesOfTheMesh) {
    const std::vector<BlendTriangles> layers = adaptive_layers(lumigraph_, views_, eye_, {});
    ASSERT_EQ(layers.size(), 2U);
    EXPECT_GT(layers[1].count(), 10U);
    EXPECT_LT(layers[1].count(), layers[0].count());
    for (const BlendVertex& corner : layers[1].vertices) {
        EXPECT_GT(corner.confidence, 0.0F);
        EXPECT_EQ(corner.opacity, 1.0F);
    }
}

TEST_F(SeenParts, CountForWhatAFrameMayHave) {
    const auto count = [&](std::size_t most) {
        return count_of(adaptive_layers(lumigraph_, views_, eye_, {.max_triangles = most}));
    };
    const std::size_t all = count(0);
    for (const std::size_t most : {all / 8, all / 4, all / 2, all - 5, all})
        EXPECT_LE(count(most), most);
}

TEST_F(SeenParts, AreNotLaidOverWhatFades) {
    EXPECT_EQ(adaptive_layers(lumigraph_, views_, eye_, {.fade_beyond_capture = true}).size(), 1U);
}

TEST_F(SeenParts, AreNotLaidOverGuesses) {
    for (LumigraphView& view : lumigraph_.views) view.depth = {};
    EXPECT_EQ(adaptive_layers(lumigraph_, searched_views(lumigraph_), eye_, {}).size(), 1U);
}

}  // namespace
}  // namespace lumi
