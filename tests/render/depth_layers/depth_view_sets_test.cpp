#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "render/depth_layers/depth_layer_views.h"
#include "render/paths/pose_between.h"
#include "render/view_choice/depth_view_choice.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

Eye eye_near_ball(double along) {
    const Eye from = eye_at({1, -2, -7}, {0, 0, 0}, pinhole_camera(64, 48, 60));
    const Eye to = eye_at({-3, 1, -5}, {0, 0.2, 0}, pinhole_camera(64, 48, 60));
    return {from.camera, pose_between(from.cam_from_world, to.cam_from_world, along)};
}

/// For each view the share of the picture in which it is asked.
std::map<int, double> shares_of_views(const std::vector<DepthViewSet>& sets) {
    std::map<int, double> shares;
    for (const DepthViewSet& set : sets)
        for (const int view : set.view_indices) shares[view] += set.share;
    return shares;
}

double largest_difference(std::map<int, double> a, std::map<int, double> b) {
    double largest = 0;
    for (const auto& [view, share] : a) largest = std::max(largest, std::abs(share - b[view]));
    for (const auto& [view, share] : b) largest = std::max(largest, std::abs(share - a[view]));
    return largest;
}

std::map<int, double> shares_at(const Lumigraph& lumigraph, double along) {
    return shares_of_views(depth_view_sets(lumigraph, eye_near_ball(along), 3));
}

/// What is left of the change between two eyes when the way between them is halved again and again,
/// each time the half that changes more.
double jump_between(const Lumigraph& lumigraph, double begin, double end) {
    for (int i = 0; i < 12; ++i) {
        const double middle = 0.5 * (begin + end);
        const auto between = shares_at(lumigraph, middle);
        const bool first_half = largest_difference(shares_at(lumigraph, begin), between) >
                                largest_difference(between, shares_at(lumigraph, end));
        (first_half ? end : begin) = middle;
    }
    return largest_difference(shares_at(lumigraph, begin), shares_at(lumigraph, end));
}

TEST(DepthViewSets, ShareThePictureAmongThem) {
    const Lumigraph lumigraph = ball_in_sky();
    for (const double along : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
        const auto sets = depth_view_sets(lumigraph, eye_near_ball(along), 3);
        ASSERT_LE(sets.size(), static_cast<std::size_t>(kMaxDepthViewSets));
        const double sum =
            std::accumulate(sets.begin(), sets.end(), 0.0,
                            [](double before, const auto& set) { return before + set.share; });
        EXPECT_NEAR(sum, 1.0, 1e-12);
        for (const DepthViewSet& set : sets) EXPECT_EQ(set.view_indices.size(), 3U);
        EXPECT_EQ(strip_ends(sets, 64).back(), 64);
    }
}

TEST(DepthViewSets, AreOneWhereAnEyeIsAtAView) {
    const Lumigraph lumigraph = ball_in_sky();
    const LumigraphView& view = lumigraph.views[3];
    const Eye eye{view.camera, view.cam_from_world};
    for (const DepthViewSet& set : depth_view_sets(lumigraph, eye, 3))
        EXPECT_EQ(set.view_indices.front(), 3);
}

TEST(DepthViewSets, AskNoViewThatHasNone) {
    Lumigraph lumigraph = ball_in_sky();
    const Eye eye = eye_near_ball(0.3);
    const std::vector<int> chosen = choose_depth_views(lumigraph, eye, 3);
    lumigraph.views[static_cast<std::size_t>(chosen.front())].depth = {};
    const auto sets = depth_view_sets(lumigraph, eye, 3);
    ASSERT_FALSE(sets.empty());
    for (const DepthViewSet& set : sets) {
        EXPECT_EQ(set.view_indices.size(), 3U);
        EXPECT_EQ(std::count(set.view_indices.begin(), set.view_indices.end(), chosen.front()), 0);
    }
}

TEST(ThreeWithRepeats, NameTheLastAgain) {
    EXPECT_EQ(three_with_repeats({7}), (std::array<int, 3>{7, 7, 7}));
    EXPECT_EQ(three_with_repeats({7, 2}), (std::array<int, 3>{7, 2, 2}));
    EXPECT_EQ(three_with_repeats({7, 2, 5}), (std::array<int, 3>{7, 2, 5}));
}

// A choice without shares changes by a whole view, however short the way.
TEST(DepthViewSets, ChangeSteadilyWithTheEye) {
    const Lumigraph lumigraph = ball_in_sky();
    constexpr int kPieces = 24;
    int exchanges = 0;
    for (int i = 0; i < kPieces; ++i) {
        const double begin = static_cast<double>(i) / kPieces;
        const double end = static_cast<double>(i + 1) / kPieces;
        EXPECT_LT(jump_between(lumigraph, begin, end), 0.05) << begin;
        exchanges += choose_depth_views(lumigraph, eye_near_ball(begin), 3) ==
                             choose_depth_views(lumigraph, eye_near_ball(end), 3)
                         ? 0
                         : 1;
    }
    EXPECT_GT(exchanges, 1);
}

TEST(StripEnds, LieWhereSharesEnd) {
    EXPECT_EQ(strip_ends({{{0}, 0.25}, {{1}, 0.75}}, 8), (std::vector<int>{2, 8}));
    EXPECT_EQ(strip_ends({{{0}, 1.0}}, 5), (std::vector<int>{5}));
}

/// Where silhouettes are smooth a pixel has two texels in a row.
TEST(StripEnds, LieBetweenPixelsOfTwoTexels) {
    for (int i = 0; i <= 100; ++i) {
        const double share = i / 100.0;
        const std::vector<int> ends = strip_ends({{{0}, share}, {{1}, 1 - share}}, 50);
        EXPECT_EQ(ends.front() % 2, 0) << share;
        EXPECT_NEAR(ends.front(), 50 * share, 1) << share;
    }
}

TEST(DepthLayerViews, KeepAViewOfSeveralSetsInOneLayer) {
    EXPECT_EQ(depth_layer_views({{{7, 2, 5}, 0.5}, {{2, 7, 6}, 0.5}}, 3),
              (DepthLayerViews{{7, 2, 5}, {7, 2, 6}}));
}

TEST(DepthLayerViews, MoveAViewWhoseLayerIsTaken) {
    // In the third set 5 has the first layer, where 7 was in the first set.
    EXPECT_EQ(depth_layer_views({{{7}, 0.4}, {{5}, 0.3}, {{5, 7}, 0.3}}, 2),
              (DepthLayerViews{{7, kNoView}, {5, kNoView}, {5, 7}}));
}

}  // namespace
}  // namespace lumi
