#include "render/depth_search/depth_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

/// The eye's inverse depth of the card at z = 3, which spans +-0.7 by +-0.5, or the wall at z = 6.
double inverse_depth_before_wall(const Eye& eye, const Eigen::Vector2d& pixel) {
    const Eigen::Vector3d from = centre_in_world(eye.cam_from_world);
    const Eigen::Vector3d direction =
        eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, pixel);
    const double to_card = (3 - from.z()) / direction.z();
    const Eigen::Vector3d on_card = from + to_card * direction;
    const bool is_card = std::abs(on_card.x()) < 0.7 && std::abs(on_card.y()) < 0.5;
    return 1 / (is_card ? to_card : (6 - from.z()) / direction.z());
}

TEST(DepthSearch, FindsWhatTheRayMeetsFirst) {
    const Lumigraph lumigraph = card_before_wall();
    const SearchedViews views = searched_views(lumigraph);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0, 1);
    int right = 0;
    int asked = 0;
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(0.21, 0.13, 0.02), Eigen::Vector3d(-0.2, 0.1, -0.6),
          Eigen::Vector3d(0.1, -0.1, 0.9)}) {
        const Eye eye = eye_at(place, {0, 0, 4}, pinhole_camera(64, 48, 80));
        const DepthSearch search(lumigraph, views, eye);
        for (int i = 0; i < 500; ++i) {
            const Eigen::Vector2d pixel(64 * share(random), 48 * share(random));
            const auto hit = search.first_hit(pixel, {0, 1, 5});
            ++asked;
            // A hundredth of the inverse depth is a hundredth of 20 pixels of disparity.
            const double truth = inverse_depth_before_wall(eye, pixel);
            if (hit && std::abs(hit->inverse_depth - truth) < 0.01 * truth) ++right;
        }
    }
    // Wrong are rays that pass the card's outline by less than a sample of the depth maps.
    EXPECT_GT(right, 0.95 * asked);
}

TEST(DepthSearch, AtACameraIsItsDepthMap) {
    const Lumigraph lumigraph = ball_in_sky();
    const LumigraphView& view = lumigraph.views[4];
    const Eye eye{view.camera, view.cam_from_world};
    const SearchedViews views = searched_views(lumigraph);
    const DepthSearch search(lumigraph, views, eye);
    for (int y = 0; y < 48; y += 5) {
        for (int x = 0; x < 64; x += 5) {
            const auto hit = search.first_hit({x + 0.5, y + 0.5}, {4, 4, 4});
            ASSERT_TRUE(hit.has_value()) << x << ' ' << y;
            EXPECT_NEAR(hit->inverse_depth, view.depth.inverse_depth(x, y), 1e-6);
        }
    }
}

TEST(DepthSearch, FindsTheWallWhereTheRayComesOutFromBehindTheCard) {
    const Lumigraph lumigraph = card_before_wall();
    const SearchedViews views = searched_views(lumigraph);
    // Beside the card and already behind it: all cameras see the ray pass behind the card.
    const Eigen::Vector3d from(-2, 0, 3.2);
    const Eigen::Vector3d on_wall(2.2, 0, 6);
    const Eye eye = eye_at(from, on_wall, pinhole_camera(65, 49, 60));
    const DepthSearch search(lumigraph, views, eye);
    const double truth = 1 / (on_wall - from).norm();
    for (int view = 0; view < static_cast<int>(lumigraph.views.size()); ++view) {
        const auto hit = search.first_hit({32.5, 24.5}, {view, view, view});
        ASSERT_TRUE(hit.has_value()) << view;
        EXPECT_NEAR(hit->inverse_depth, truth, 0.02 * truth) << view;
    }
}

// Neighbouring samples of the ball differ by more than a pixel of disparity: cameras stand 60
// degrees apart.
TEST(DepthSearch, MeetsSlopesThatViewsSeeFromAside) {
    std::vector<Eye> cameras;
    for (const LumigraphView& view : ball_in_sky().views)
        cameras.push_back({pinhole_camera(320, 240, 240), view.cam_from_world});
    const Lumigraph lumigraph = photographed(AnalyticScene::kBallInSky, cameras);
    const SearchedViews views = searched_views(lumigraph);
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto direction = [&] {
        return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    };
    int asked = 0;
    int right = 0;
    for (int i = 0; i < 400; ++i) {
        const Eigen::Vector3d from = 2.5 * direction();
        const Eye eye = eye_at(from, {0, 0, 0}, pinhole_camera(64, 48, 60));
        const DepthSearch search(lumigraph, views, eye);
        for (int view = 0; view < 12; ++view) {
            const Eigen::Vector3d on_ball = direction();
            const auto faces = [&](const Eigen::Vector3d& centre) {
                return (centre - on_ball).normalized().dot(on_ball) > 0.4;
            };
            const Eye& asked_camera = cameras[static_cast<std::size_t>(view)];
            if (!faces(from) || !faces(centre_in_world(asked_camera.cam_from_world))) continue;
            const Eigen::Vector3d in_eye = eye.cam_from_world * on_ball;
            const auto hit = search.first_hit(*project(eye.camera, in_eye), {view, view, view});
            ++asked;
            if (hit && std::abs(hit->inverse_depth * in_eye.z() - 1) < 0.02) ++right;
        }
    }
    EXPECT_GT(asked, 100);
    EXPECT_GT(right, 0.98 * asked) << right << " of " << asked;
}

TEST(DepthSearch, MeetsNothingWhereNoPhotographLooks) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0, 0, 0}, {0, 0, -4}, pinhole_camera(64, 48, 60));
    const SearchedViews views = searched_views(lumigraph);
    const DepthSearch search(lumigraph, views, eye);
    EXPECT_FALSE(search.first_hit({32, 24}, {0, 1, 2}).has_value());
}

TEST(DepthSearch, KnowsWhoSeesTheWallBehindTheCard) {
    const Lumigraph lumigraph = card_before_wall();
    // From the left, the wall right behind the card's left edge; cameras on the right do not see
    // it.
    const Eye eye = eye_at({-1.4, 0, 0}, {-1, 0, 6}, pinhole_camera(64, 48, 60));
    const SearchedViews views = searched_views(lumigraph);
    const DepthSearch search(lumigraph, views, eye);
    const Eigen::Vector3d on_wall(-0.9, 0, 6);
    const Eigen::Vector3d in_eye = eye.cam_from_world * on_wall;
    const auto pixel = project(eye.camera, in_eye);
    ASSERT_TRUE(pixel.has_value());
    const double inverse_depth = 1 / in_eye.z();
    for (int i = 0; i < 9; ++i) {
        const Eigen::Vector3d camera =
            centre_in_world(lumigraph.views[static_cast<std::size_t>(i)].cam_from_world);
        const double at_card =
            camera.x() + (on_wall.x() - camera.x()) * (3 - camera.z()) / (6 - camera.z());
        // A pixel beside the card's edge may fall to either side.
        if (std::abs(std::abs(at_card) - 0.7) < 0.06) continue;
        EXPECT_EQ(search.visibility(*pixel, inverse_depth, i), std::abs(at_card) < 0.7 ? 0.0 : 1.0)
            << i;
    }
}

// The card hides parts of the wall from the eye that both views see: one of them past the card's
// edge, while the ray meets the card in the other.
TEST(DepthSearch, TheNearestCountsWhereTwoViewsMeetDifferentSurfaces) {
    const Lumigraph lumigraph = card_before_wall();
    const SearchedViews views = searched_views(lumigraph);
    const Eye eye{lumigraph.views[0].camera, lumigraph.views[0].cam_from_world};
    const DepthSearch search(lumigraph, views, eye);
    const double apart = 0.3 * (1.0 / 3 - 1.0 / 6);
    int differing = 0;
    for (int far_view = 1; far_view < 9; ++far_view) {
        for (int near_view = 1; near_view < 9; ++near_view) {
            for (int y = 0; y < eye.camera.height_px; ++y) {
                for (int x = 0; x < eye.camera.width_px; ++x) {
                    const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
                    const auto far = search.first_hit(pixel, {far_view, far_view, far_view});
                    const auto near = search.first_hit(pixel, {near_view, near_view, near_view});
                    if (!far || !near || near->inverse_depth - far->inverse_depth < apart) continue;
                    ++differing;
                    const auto both = search.first_hit(pixel, {far_view, near_view, near_view});
                    ASSERT_TRUE(both);
                    EXPECT_EQ(both->inverse_depth, near->inverse_depth) << x << ' ' << y;
                }
            }
        }
    }
    EXPECT_GT(differing, 100);
}

TEST(DepthSearch, WhatOneViewAloneSeesStaysWhereThoseThatAgreeDoNotLookPastIt) {
    Lumigraph lumigraph = post_behind_post();
    const Eye eye = eye_at({0, 0, 0}, {0, 0, 4}, pinhole_camera(61, 45, 60));
    const Eigen::Vector2d along_axis(30.5, 22.5);
    const auto depth_of = [&] {
        const SearchedViews views = searched_views(lumigraph);
        const auto hit = DepthSearch(lumigraph, views, eye).first_hit(along_axis, {0, 1, 2});
        return hit ? 1 / hit->inverse_depth : 0.0;
    };
    EXPECT_NEAR(depth_of(), 4.5, 0.01);
    // What the first imagines at z = 2 the others look past, to the near post and beside it.
    for (float& inverse_depth : lumigraph.views[0].depth.inverse_depth.pixels())
        inverse_depth = 0.5F;
    EXPECT_NEAR(depth_of(), 6, 0.02);
}

TEST(DepthSearch, ViewsThatMeetAPointSeeIt) {
    const Lumigraph lumigraph = card_before_wall();
    const SearchedViews views = searched_views(lumigraph);
    const Eye eye = eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(64, 48, 80));
    const DepthSearch search(lumigraph, views, eye);
    const std::array<int, 3> asked{0, 1, 5};
    int met = 0;
    int hidden = 0;
    for (int y = 0; y < eye.camera.height_px; ++y) {
        for (int x = 0; x < eye.camera.width_px; ++x) {
            const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
            const auto hit = search.first_hit(pixel, asked);
            if (!hit) continue;
            int by = 0;
            for (int view = 0; view < static_cast<int>(lumigraph.views.size()); ++view) {
                if (!hit->is_met_by(view)) continue;
                ++by;
                EXPECT_NE(std::find(asked.begin(), asked.end(), view), asked.end());
                if (search.visibility(pixel, hit->inverse_depth, view) <= 0) ++hidden;
            }
            EXPECT_EQ(by, hit->support);
            met += by;
        }
    }
    EXPECT_GT(met, 5000);
    // Of two surfaces that meet within a sample each may hide the other.
    EXPECT_LT(hidden, met / 100);
}

/// Three views whose maps are planes before them, at these inverse depths; all are guesses but
/// those of `seen`.
Lumigraph guessed_planes(const std::array<float, 3>& inverse_depths, int seen) {
    Lumigraph lumigraph = card_before_wall();
    for (int i = 0; i < 3; ++i) {
        DepthMap& depth = lumigraph.views[static_cast<std::size_t>(i)].depth;
        for (float& inverse_depth : depth.inverse_depth.pixels())
            inverse_depth = inverse_depths[static_cast<std::size_t>(i)];
        for (std::uint8_t& confidence : depth.confidence.pixels()) confidence = i == seen ? 255 : 0;
    }
    return lumigraph;
}

TEST(DepthSearch, AGuessIsThatOfTheViewAskedFirst) {
    const Lumigraph lumigraph = guessed_planes({0.2F, 0.25F, 0.25F}, -1);
    const SearchedViews views = searched_views(lumigraph);
    const Eye eye = eye_at({0.05, 0.03, 0}, {0, 0, 4}, pinhole_camera(64, 48, 80));
    const DepthSearch search(lumigraph, views, eye);
    for (const auto& asked : {std::array{0, 1, 2}, std::array{1, 0, 2}, std::array{2, 1, 0}}) {
        const auto alone = search.first_hit({32, 24}, {asked[0], asked[0], asked[0]});
        const auto together = search.first_hit({32, 24}, asked);
        ASSERT_TRUE(alone && together);
        EXPECT_EQ(together->inverse_depth, alone->inverse_depth);
        EXPECT_EQ(together->kind, DepthKind::kFilled);
        // As near as a search of surfaces whose depths may differ comes, and never to the other.
        EXPECT_NEAR(together->inverse_depth, asked[0] == 0 ? 0.2 : 0.25, 0.3 * (0.25 - 0.2));
    }
}

TEST(DepthSearch, AGuessGivesWayToWhatAnotherViewHasSeen) {
    const Lumigraph lumigraph = guessed_planes({0.25F, 0.25F, 0.2F}, 2);
    const SearchedViews views = searched_views(lumigraph);
    const Eye eye = eye_at({0.05, 0.03, 0}, {0, 0, 4}, pinhole_camera(64, 48, 80));
    const DepthSearch search(lumigraph, views, eye);
    const auto hit = search.first_hit({32, 24}, {0, 1, 2});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->kind, DepthKind::kSeen);
    EXPECT_NEAR(hit->inverse_depth, 0.2, 0.01);
}

}  // namespace
}  // namespace lumi
