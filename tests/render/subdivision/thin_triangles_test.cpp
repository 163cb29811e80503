#include "render/subdivision/thin_triangles.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "render/modes/adaptive.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr double kBarFocal_px = 260.0;
constexpr double kBarDepth = 3.0;
constexpr double kHalfBar = 0.023;

Eye before_bar(double x, double y, double z = 0) {
    return eye_at({x, y, z}, {x, y, 6}, pinhole_camera(256, 192, kBarFocal_px));
}

/// A bar four pixels wide before a wall, and four cameras around the eye.
class ThinTriangles : public testing::Test {
 protected:
    static Lumigraph lumigraph_of(AnalyticScene scene) {
        Lumigraph lumigraph = photographed(scene, {before_bar(0.4, 0.3), before_bar(-0.4, 0.3),
                                                   before_bar(-0.4, -0.3), before_bar(0.4, -0.3)});
        lumigraph.drawing.draws_thin = true;
        return lumigraph;
    }

    [[nodiscard]] BlendTriangles drawn_from(const Eye& eye, std::size_t most = 0) const {
        return thin_triangles(scene_, views_, eye, DepthSearch(scene_, views_, eye), most);
    }

    Lumigraph scene_ = lumigraph_of(AnalyticScene::kBarBeforeWall);
    SearchedViews views_ = searched_views(scene_);
};

double area_px2(const BlendTriangles& triangles) {
    double area = 0;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) {
            return vector_of(triangles.vertices[triangles.indices[i + k]].pixel);
        };
        const Eigen::Vector2d ab = at(1) - at(0);
        const Eigen::Vector2d ac = at(2) - at(0);
        area += 0.5 * std::abs(ab.x() * ac.y() - ab.y() * ac.x());
    }
    return area;
}

TEST_F(ThinTriangles, AreTheBarOnceWhereTheEyeSeesIt) {
    for (const double x : {0.0, 0.15, -0.3}) {
        const BlendTriangles triangles = drawn_from(before_bar(x, 0.05));
        ASSERT_GT(triangles.count(), 0U);
        const double scale = kBarFocal_px / kBarDepth;
        for (const std::uint32_t index : triangles.indices) {
            const BlendVertex& corner = triangles.vertices[index];
            const Eigen::Vector2d pixel = vector_of(corner.pixel);
            EXPECT_NEAR(pixel.x(), 128 - scale * x, scale * kHalfBar + 1.5);
            EXPECT_NEAR(static_cast<double>(corner.inverse_depth), 1 / kBarDepth, 0.01);
        }
        // The eye sees 192 pixels of its height; triangles reach beyond the picture.
        const double width_px = 2 * scale * kHalfBar;
        EXPECT_GT(area_px2(triangles), 0.7 * width_px * 138);
        EXPECT_LT(area_px2(triangles), 1.4 * width_px * 192);
    }
}

TEST_F(ThinTriangles, LookTheBarUpWhereAPhotographShowsIt) {
    const Eye eye = before_bar(0.1, -0.1);
    const DepthSearch search(scene_, views_, eye);
    for (const BlendVertex& corner : drawn_from(eye).vertices) {
        const auto view = static_cast<int>(corner.view_layers[0]);
        const auto in_view = search.line_in(view, vector_of(corner.pixel))
                                 .at(static_cast<double>(corner.inverse_depth));
        ASSERT_TRUE(in_view.has_value());
        EXPECT_LT((in_view->pixel - vector_of(corner.view_pixels[0])).norm(), 0.01);
        EXPECT_NEAR(in_view->depth_ratio, static_cast<double>(corner.depth_ratios[0]), 1e-3);
        EXPECT_EQ(corner.weights, (std::array<float, 3>{1, 0, 0}));
    }
}

TEST_F(ThinTriangles, AreNoneBehindTheEyeNorBehindAnything) {
    EXPECT_EQ(drawn_from(before_bar(0, 0, 4)).count(), 0U) << "the eye has passed the bar";
    // The views' own map of what is thin, before which now stands a card.
    const Lumigraph hidden = lumigraph_of(AnalyticScene::kCardBeforeWall);
    SearchedViews views = searched_views(hidden);
    for (std::size_t i = 0; i < views.thin.size(); ++i) {
        EXPECT_TRUE(views.thin[i].indices.empty()) << "a card is not thin";
        views.thin[i] = views_.thin[i];
        for (Eigen::Vector3f& vertex : views.thin[i].vertices) vertex.z() = 0.25F;
    }
    const Eye eye = before_bar(0, 0);
    const BlendTriangles triangles =
        thin_triangles(hidden, views, eye, DepthSearch(hidden, views, eye), 0);
    EXPECT_GT(triangles.count(), 0U) << "it reaches beyond the card";
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        Eigen::Vector2d middle(0, 0);
        for (std::size_t k = 0; k < 3; ++k)
            middle += vector_of(triangles.vertices[triangles.indices[i + k]].pixel) / 3;
        EXPECT_GT(std::abs(middle.y() - 96), 0.5 / kBarDepth * kBarFocal_px - 2);
    }
}

TEST_F(ThinTriangles, AreDrawnWhereALumigraphSaysSoAlone) {
    const Eye eye = before_bar(0.1, 0);
    const std::vector<BlendTriangles> with = adaptive_layers(scene_, views_, eye, {});
    ASSERT_EQ(with.size(), 2U);
    EXPECT_GT(with[1].count(), 0U);
    scene_.drawing.draws_thin = false;
    const std::vector<BlendTriangles> without =
        adaptive_layers(scene_, searched_views(scene_), eye, {});
    ASSERT_EQ(without.size(), 1U);
    EXPECT_EQ(without[0].count(), with[0].count());
}

TEST_F(ThinTriangles, AreTheLargestWhereThereMayBeFew) {
    const Eye eye = before_bar(0.1, 0);
    const BlendTriangles all = drawn_from(eye);
    ASSERT_GT(all.count(), 4U);
    const BlendTriangles few = drawn_from(eye, 4);
    EXPECT_EQ(few.count(), 4U);
    EXPECT_GT(area_px2(few) / 4, area_px2(all) / static_cast<double>(all.count()));
    EXPECT_EQ(drawn_from(eye, all.count()).count(), all.count());
}

TEST_F(ThinTriangles, CountForWhatAFrameMayHave) {
    RenderOptions options;
    options.max_triangles = 60;
    const std::vector<BlendTriangles> layers =
        adaptive_layers(scene_, views_, before_bar(0.1, 0), options);
    ASSERT_EQ(layers.size(), 2U);
    EXPECT_GT(layers[1].count(), 0U);
    EXPECT_LE(layers[0].count() + layers[1].count(), 60U);
}

TEST_F(ThinTriangles, AreSortedFromFarToNear) {
    const BlendTriangles triangles = drawn_from(before_bar(0.1, 0.2, 0.5));
    double last = 0;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        double inverse_depth = 0;
        for (std::size_t k = 0; k < 3; ++k)
            inverse_depth +=
                static_cast<double>(triangles.vertices[triangles.indices[i + k]].inverse_depth) / 3;
        EXPECT_GE(inverse_depth, last - 1e-6);
        last = inverse_depth;
    }
}

}  // namespace
}  // namespace lumi
