#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "meshing/depth/depth_choice.h"
#include "meshing/depth/held_out_photograph.h"
#include "meshing/depth/held_out_points.h"
#include "meshing/depth/photograph_loss.h"
#include "meshing/depth_models/depth_model.h"
#include "meshing/depth_models/pair_stereo.h"
#include "meshing/depth_models/patch_match.h"
#include "tests/calib/interrupted_progress.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

bool everywhere(const Eigen::Vector3d&) { return true; }

/// Exact points of every view on a grid, so many pixels apart.
void add_points(KnownDepthScene& known, int spacing_px) {
    for (std::size_t i = 0; i < known.scene.views.size(); ++i) {
        for (int y = spacing_px / 2; y < 180; y += spacing_px) {
            for (int x = spacing_px / 2; x < 240; x += spacing_px) {
                // Not in rows: triangles of all shapes.
                const int at_x = std::min(239, x + y % 5);
                known.scene.views[i].points.push_back(
                    {{at_x + 0.5, y + 0.5}, static_cast<double>(known.inverse_depths[i](at_x, y))});
            }
        }
    }
}

KnownDepthScene slanted_wall(const Eigen::Vector3d& normal) {
    KnownDepthScene known =
        known_depth_scene({{{0, 0, 2}, normal, everywhere, noise_texture(0.03, 5)}},
                          cross_of_centres(0.12), {0.1, 1.2});
    add_points(known, 12);
    return known;
}

/// Boards at many depths before a wall: points tell little of what lies between them.
KnownDepthScene boards() {
    std::vector<TexturedPlane> planes{{{0, 0, 3}, {0, 0, 1}, everywhere, noise_texture(0.04, 5)}};
    for (int i = 0; i < 9; ++i) {
        const double depth = 1.6 + 0.12 * ((5 * i) % 9);
        const double left = (-0.5 + 0.11 * i) * depth;
        planes.push_back(
            {{0, 0, depth},
             {0, 0, 1},
             [=](const Eigen::Vector3d& p) { return p.x() > left && p.x() < left + 0.055 * depth; },
             noise_texture(0.02, static_cast<unsigned>(20 + i))});
    }
    KnownDepthScene known = known_depth_scene(planes, cross_of_centres(0.2), {0.1, 1.0});
    add_points(known, 24);
    return known;
}

double share_right(const DepthMap& map, const KnownDepthScene& known, bool only_confident) {
    constexpr int kMargin = 20;
    const FloatImage errors = errors_px(map, known.inverse_depths[0], known.scene.views[0]);
    int all = 0;
    int right = 0;
    for (int y = kMargin; y < 180 - kMargin; ++y) {
        for (int x = kMargin; x < 240 - kMargin; ++x) {
            if (only_confident && map.confidence(x, y) == 0) continue;
            ++all;
            if (errors(x, y) <= 1.0F) ++right;
        }
    }
    return all == 0 ? 0.0 : static_cast<double>(right) / all;
}

std::vector<GrayImage> no_masks(const KnownDepthScene& known) {
    return std::vector<GrayImage>(known.scene.views.size());
}

std::string chosen(const KnownDepthScene& known) {
    SilentProgress progress;
    return choose_depth_model(known.scene, no_masks(known), "sweep", 2, progress).model;
}

TEST(DepthLadder, EveryRungSaysSomethingFiniteOfEveryPixel) {
    const KnownDepthScene known = boards();
    for (const std::string& name : depth_model_names()) {
        const DepthEstimate estimate = depth_model_named(name)->estimate(known.scene, 0);
        ASSERT_EQ(estimate.map.inverse_depth.width(), 240) << name;
        ASSERT_EQ(estimate.map.confidence.height(), 180) << name;
        for (const float value : estimate.map.inverse_depth.pixels()) {
            ASSERT_TRUE(std::isfinite(value) && value >= 0) << name;
        }
    }
}

TEST(PairStereo, FindsASlantedWall) {
    const KnownDepthScene known = slanted_wall({0.3, 0.2, 1});
    const DepthMap map = pair_stereo(known.scene, 0);
    EXPECT_GT(share_right(map, known, true), 0.97);
    const auto known_pixels =
        std::count_if(map.confidence.pixels().begin(), map.confidence.pixels().end(),
                      [](std::uint8_t value) { return value > 0; });
    EXPECT_GT(static_cast<double>(known_pixels), 0.9 * 240 * 180);
}

TEST(PairStereo, LeavesOutPairsInSightOfEachOther) {
    KnownDepthScene known =
        known_depth_scene({{{0, 0, 2}, {0, 0, 1}, everywhere, noise_texture(0.03, 5)}},
                          {{0, 0, 0}, {0.1, 0, 0}, {0, 0, 0.3}}, {0.1, 1.2});
    EXPECT_EQ(rectifiable_pairs(known.scene, 0), 1) << "the third camera stands ahead";
}

TEST(PatchMatch, BringsASlantedWallToAFractionOfAPixel) {
    const KnownDepthScene known = slanted_wall({0.5, 0.4, 1});
    std::vector<DepthEstimate> estimates;
    for (std::size_t i = 0; i < known.scene.views.size(); ++i) {
        DepthMap map{known.inverse_depths[i], GrayImage(240, 180, 255)};
        // A staircase of steps of one pixel.
        const double step = 1 / known.scene.views[0].disparity_px_per_inverse_depth;
        for (float& value : map.inverse_depth.pixels()) {
            value = static_cast<float>(step * std::round(static_cast<double>(value) / step));
        }
        estimates.push_back({map, "sweep", true, false});
    }
    const DepthMap refined = patch_match(known.scene, estimates, 0);
    const FloatImage errors = errors_px(refined, known.inverse_depths[0], known.scene.views[0]);
    int fine = 0;
    int all = 0;
    for (int y = 20; y < 160; ++y) {
        for (int x = 20; x < 220; ++x) {
            ++all;
            if (errors(x, y) <= 0.25F) ++fine;
        }
    }
    EXPECT_GT(fine, 0.9 * all);
}

TEST(PatchMatch, OnlyWhereUnsureMendsWhatIsWrongAndLeavesWhatTwoViewsConfirm) {
    const KnownDepthScene known = slanted_wall({0.5, 0.4, 1});
    std::vector<DepthEstimate> estimates;
    for (const FloatImage& inverse_depth : known.inverse_depths) {
        estimates.push_back({{inverse_depth, GrayImage(240, 180, 255)}, "sweep", true, false});
    }
    const auto is_damaged = [](int x, int y) { return x >= 100 && x < 130 && y >= 80 && y < 100; };
    const float three_px =
        static_cast<float>(3 / known.scene.views[0].disparity_px_per_inverse_depth);
    FloatImage& own = estimates[0].map.inverse_depth;
    for (int y = 80; y < 100; ++y) {
        for (int x = 100; x < 130; ++x) own(x, y) += three_px;
    }
    const DepthMap refined = patch_match(known.scene, estimates, 0, {.only_where_unsure = true});
    const FloatImage errors = errors_px(refined, known.inverse_depths[0], known.scene.views[0]);
    int mended = 0;
    int left = 0;
    int others = 0;
    for (int y = 20; y < 160; ++y) {
        for (int x = 20; x < 220; ++x) {
            if (is_damaged(x, y)) {
                mended += errors(x, y) <= 0.5F ? 1 : 0;
                continue;
            }
            ++others;
            left += refined.inverse_depth(x, y) == own(x, y) ? 1 : 0;
        }
    }
    EXPECT_GT(mended, 0.9 * 30 * 20);
    EXPECT_GT(left, 0.9 * others);
}

TEST(PatchMatch, OnlyWhereUnsureMendsWhatAllViewsConfirmWhereCleanPhotographsFitBetter) {
    // Half of the wall stands before its place in all views, which fits fairly well.
    const KnownDepthScene known = slanted_wall({0.5, 0.4, 1});
    const DepthView& view = known.scene.views[0];
    constexpr double kBefore_px = 0.7;
    const double before = kBefore_px / view.disparity_px_per_inverse_depth;
    std::vector<DepthEstimate> estimates;
    for (std::size_t i = 0; i < known.scene.views.size(); ++i) {
        FloatImage inverse_depth = known.inverse_depths[i];
        const DepthView& own = known.scene.views[i];
        for (int y = 0; y < inverse_depth.height(); ++y) {
            for (int x = 0; x < inverse_depth.width(); ++x) {
                const double depth = 1.0 / static_cast<double>(inverse_depth(x, y));
                const Eigen::Vector3d point =
                    inverse(own.cam_from_world) *
                    (depth * unproject(own.camera, Eigen::Vector2d(x + 0.5, y + 0.5)));
                if (std::abs(point.x()) < 0.15) inverse_depth(x, y) += static_cast<float>(before);
            }
        }
        estimates.push_back({{inverse_depth, GrayImage(240, 180, 255)}, "sweep", true, false});
    }
    const DepthMap refined = patch_match(known.scene, estimates, 0, {.only_where_unsure = true});
    const FloatImage errors = errors_px(refined, known.inverse_depths[0], view);
    int mended = 0;
    int displaced = 0;
    for (int y = 20; y < 160; ++y) {
        for (int x = 20; x < 220; ++x) {
            if (estimates[0].map.inverse_depth(x, y) == known.inverse_depths[0](x, y)) continue;
            ++displaced;
            if (errors(x, y) <= 0.35F) ++mended;
        }
    }
    ASSERT_GT(displaced, 2000);
    EXPECT_GT(mended, 0.7 * displaced);
}

TEST(PatchMatch, WhereItsWindowsSeeNoTextureTheEstimatesClaimsStand) {
    KnownDepthScene known = slanted_wall({0.5, 0.4, 1});
    std::vector<DepthEstimate> estimates;
    for (std::size_t i = 0; i < known.scene.views.size(); ++i) {
        for (Rgb8& color : known.scene.views[i].photograph.pixels()) color = {90, 90, 90};
        DepthMap map{known.inverse_depths[i], GrayImage(240, 180, 0)};
        for (int y = 0; y < 180; ++y) {
            for (int x = 0; x < 120; ++x) map.confidence(x, y) = 255;
        }
        estimates.push_back({std::move(map), "sweep", true, false});
    }
    for (const bool only_where_unsure : {false, true}) {
        const DepthMap refined =
            patch_match(known.scene, estimates, 0, {.only_where_unsure = only_where_unsure});
        EXPECT_EQ(refined.confidence.pixels(), estimates[0].map.confidence.pixels());
        EXPECT_EQ(refined.inverse_depth.pixels(), estimates[0].map.inverse_depth.pixels());
    }
}

TEST(PatchMatch, WhereMostWindowsFindNothingAlikeNoClaimIsBelieved) {
    KnownDepthScene known = slanted_wall({0.5, 0.4, 1});
    std::vector<DepthEstimate> estimates;
    std::uint32_t state = 1;
    for (std::size_t i = 0; i < known.scene.views.size(); ++i) {
        for (Rgb8& color : known.scene.views[i].photograph.pixels()) {
            state = state * 1664525U + 1013904223U;
            const auto gray = static_cast<std::uint8_t>(state >> 24);
            color = {gray, gray, gray};
        }
        estimates.push_back(
            {{known.inverse_depths[i], GrayImage(240, 180, 255)}, "sweep", true, false});
    }
    const DepthMap refined = patch_match(known.scene, estimates, 0, {.iterations = 1});
    const auto claimed =
        std::count(refined.confidence.pixels().begin(), refined.confidence.pixels().end(), 255);
    EXPECT_LT(static_cast<double>(claimed), 0.5 * 240 * 180);
}

TEST(DepthChoice, APlaneForAPlanarSceneAndTheSweepForATangledOne) {
    EXPECT_EQ(chosen(slanted_wall({0, 0, 1})), "plane");
    EXPECT_EQ(chosen(slanted_wall({0.5, 0.4, 1})), "slanted_plane");
    EXPECT_EQ(chosen(boards()), "sweep");
}

TEST(DepthChoice, SparsePointsForASmoothScene) {
    // Two walls that meet in an obtuse angle: no plane, but affine between points.
    KnownDepthScene known = known_depth_scene({{{0, 0, 2.2},
                                                {0.5, 0, 1},
                                                [](const Eigen::Vector3d& p) { return p.x() >= 0; },
                                                noise_texture(0.03, 5)},
                                               {{0, 0, 2.2},
                                                {-0.5, 0, 1},
                                                [](const Eigen::Vector3d& p) { return p.x() < 0; },
                                                noise_texture(0.03, 6)}},
                                              cross_of_centres(0.12), {0.1, 1.2});
    add_points(known, 8);
    EXPECT_EQ(chosen(known), "sparse");
}

/// A wall, and before it a disc that has one point in forty and a fortieth of the picture.
KnownDepthScene disc_before_wall() {
    const Eigen::Vector3d middle(0.1, -0.05, 1.3);
    KnownDepthScene known =
        known_depth_scene({{{0, 0, 2.4}, {0, 0, 1}, everywhere, noise_texture(0.03, 5)},
                           {middle,
                            {0, 0, 1},
                            [=](const Eigen::Vector3d& p) { return (p - middle).norm() < 0.11; },
                            noise_texture(0.02, 6)}},
                          cross_of_centres(0.12), {0.1, 1.2});
    add_points(known, 8);
    return known;
}

TEST(DepthChoice, AnObjectWithFewPointsIsNotFlattenedOntoTheWallBehindIt) {
    const KnownDepthScene known = disc_before_wall();
    const std::string model = chosen(known);
    const DepthMap map = depth_model_named(model)->estimate(known.scene, 0).map;
    // Its middle, as the first view sees it.
    const int x = static_cast<int>(120 + 240 * 0.1 / 1.3);
    const int y = static_cast<int>(90 - 240 * 0.05 / 1.3);
    ASSERT_NEAR(known.inverse_depths[0](x, y), 1 / 1.3, 1e-6);
    EXPECT_NEAR(map.inverse_depth(x, y), 1 / 1.3, 0.02) << model;
    EXPECT_NEAR(map.inverse_depth(20, 160), 1 / 2.4, 0.02) << model;
    const SilentProgress progress;
    const auto of_plane = held_out_points(known.scene, "plane", 2, progress);
    ASSERT_TRUE(of_plane);
    EXPECT_LT(of_plane->p95_px, 0.1) << "by which a plane would be enough";
    EXPECT_GT(of_plane->astray_share, 0.005);
}

TEST(DepthChoice, APlaneIsEnoughWhereLonePointsAreWrong) {
    KnownDepthScene known = slanted_wall({0, 0, 1});
    for (DepthView& view : known.scene.views) {
        for (std::size_t k = 7; k < view.points.size(); k += 40)
            view.points[k].inverse_depth += 0.3;
    }
    EXPECT_EQ(chosen(known), "plane");
}

TEST(DepthChoice, RoundsTheFigureThatItGives) {
    KnownDepthScene known = slanted_wall({0, 0, 1});
    for (DepthView& view : known.scene.views) {
        double error = 0.298 / view.disparity_px_per_inverse_depth;
        for (SparsePoint& point : view.points) point.inverse_depth += std::exchange(error, -error);
    }
    SilentProgress progress;
    EXPECT_THAT(
        choose_depth_model(known.scene, no_masks(known), "sweep", 2, progress).explanation,
        testing::StartsWith("plane: 95 % of the points kept back lie within 0.60 px of it"));
}

TEST(HeldOutPoints, LieOnTheSweepOfATangledSceneAndNotOnTheTrianglesBetweenPoints) {
    const KnownDepthScene known = boards();
    const SilentProgress progress;
    const auto of_points = held_out_points(known.scene, "sparse", 2, progress);
    const auto of_sweep = held_out_points(known.scene, "sweep", 2, progress);
    ASSERT_TRUE(of_points && of_sweep);
    EXPECT_LT(2 * of_sweep->p95_px, of_points->p95_px);
    const auto again = held_out_points(known.scene, "sweep", 1, progress);
    EXPECT_EQ(of_sweep->p95_px, again->p95_px);
    EXPECT_EQ(of_sweep->astray_share, again->astray_share);
}

TEST(DepthChoice, ThePhotographsDecideWherePointsLieOnOneSurfaceOnly) {
    // The boards have texture but no points: each point's surroundings are the wall's.
    KnownDepthScene known = boards();
    for (std::size_t i = 0; i < known.scene.views.size(); ++i) {
        std::erase_if(known.scene.views[i].points, [&](const SparsePoint& point) {
            return std::abs(point.inverse_depth - 1.0 / 3) > 1e-3;
        });
        // One of them is wrong by a dozen pixels, so that points alone are never enough.
        for (std::size_t k = 0; k < known.scene.views[i].points.size(); k += 12) {
            known.scene.views[i].points[k].inverse_depth += 0.3;
        }
    }
    EXPECT_EQ(chosen(known), "sweep");
}

TEST(PhotographLoss, IsLeastForTheTruth) {
    const KnownDepthScene known = boards();
    const auto loss = [&](double factor) {
        std::vector<FloatImage> depths = known.inverse_depths;
        std::vector<PredictingView> views;
        for (const std::size_t i : {0U, 2U, 3U, 4U}) {
            for (float& value : depths[i].pixels()) value *= static_cast<float>(factor);
            views.push_back({&known.scene.views[i], &depths[i]});
        }
        return photograph_loss(views, known.scene.views[1]);
    };
    EXPECT_TRUE(is_clearly_closer(loss(1), loss(1.05), 1));
    EXPECT_TRUE(is_clearly_closer(loss(1), loss(0.95), 1));
    EXPECT_FALSE(is_clearly_closer(loss(1), loss(1), 1));
}

TEST(PhotographLoss, WhatOneViewHidesAnotherShows) {
    const KnownDepthScene known = boards();
    const auto loss = [&](const std::vector<std::size_t>& from) {
        std::vector<PredictingView> views;
        for (const std::size_t i : from) {
            views.push_back({&known.scene.views[i], &known.inverse_depths[i]});
        }
        return rms_of(photograph_loss(views, known.scene.views[0]));
    };
    // One view alone cannot know what lies behind the boards, and leaves it out.
    EXPECT_LT(loss({1, 2, 3, 4}), 8.0);
    EXPECT_LT(loss({1}), 8.0);
}

TEST(PhotographLoss, WhatOneViewAloneHasWrongTheOthersOverrule) {
    const KnownDepthScene known = boards();
    const auto loss = [&](const std::vector<std::size_t>& wrong) {
        std::vector<FloatImage> depths = known.inverse_depths;
        for (const std::size_t i : wrong) {
            for (float& value : depths[i].pixels()) value *= 1.3F;  // Before all others.
        }
        std::vector<PredictingView> views;
        for (const std::size_t i : {1U, 2U, 3U, 4U}) {
            views.push_back({&known.scene.views[i], &depths[i]});
        }
        return rms_of(photograph_loss(views, known.scene.views[0]));
    };
    EXPECT_LT(loss({4}) - loss({}), 0.5 * (loss({1, 2, 3, 4}) - loss({})));
}

TEST(PhotographLoss, ATileWhereBothFailDoesNotHideTheOthers) {
    std::vector<double> current(60, 25.0);
    std::vector<double> next(60, 20.0);
    current[7] = 3000;
    next[7] = 4000;  // More than all others gain together.
    EXPECT_TRUE(is_clearly_closer(next, current, 2));
    EXPECT_FALSE(is_clearly_closer(current, next, 0));
}

TEST(HeldOutPhotograph, TheViewThatOthersSurroundIsAskedFirst) {
    const std::vector<int> asked = photographs_to_keep_back(slanted_wall({0, 0, 1}).scene);
    ASSERT_EQ(asked.size(), 3U);
    EXPECT_EQ(asked.front(), 0) << "the middle of the cross";
}

TEST(HeldOutPhotograph, AsksARungThatRefinesForItsRefinement) {
    const KnownDepthScene known = slanted_wall({0.5, 0.4, 1});
    const std::vector<GrayImage> masks = no_masks(known);
    HeldOutPhotograph photograph(known.scene, masks, 0);
    const SilentProgress progress;
    const double swept = rms_of(photograph.loss("sweep", 2, progress));
    EXPECT_LT(rms_of(photograph.loss("patch_match", 2, progress)), 0.97 * swept);
}

TEST(HeldOutPhotograph, StopsAtEachStepOfEachOfItsNeighbours) {
    const KnownDepthScene known = slanted_wall({0, 0, 1});
    const std::vector<GrayImage> masks = no_masks(known);
    // Four neighbours are matched, confirmed and filled.
    for (int questions = 0; questions <= 12; ++questions) {
        HeldOutPhotograph photograph(known.scene, masks, 0);
        const InterruptedProgress progress(questions);
        try {
            (void)photograph.loss("sweep", 1, progress);
            EXPECT_EQ(questions, 12) << "went on";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-INTERRUPTED");
            EXPECT_LT(questions, 12);
        }
    }
}

TEST(DepthChoice, TheSweepIsRefinedWhereItWinsAndNothingElseIs) {
    const auto chosen_of = [](const KnownDepthScene& known) {
        SilentProgress progress;
        return choose_depth_model(known.scene, no_masks(known), "refined_sweep", 2, progress);
    };
    EXPECT_EQ(chosen_of(slanted_wall({0, 0, 1})).model, "plane");
    const DepthChoice tangled = chosen_of(boards());
    EXPECT_EQ(tangled.model, "refined_sweep");
    EXPECT_EQ(tangled.compared.back(), "sweep") << "what refining brings is not tried";
}

TEST(DepthChoice, OnePhotographThatIsNotWhereItIsSaidToBeDoesNotDecide) {
    KnownDepthScene known = boards();
    // The photograph that is asked first.
    DepthView& middle = known.scene.views[0];
    const ColorImage photograph = middle.photograph;
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 240; ++x) middle.photograph(x, y) = photograph((x + 40) % 240, y);
    }
    EXPECT_EQ(chosen(known), "sweep");
}

KnownDepthScene wall_without_points(const std::vector<Eigen::Vector3d>& centres) {
    return known_depth_scene({{{0, 0, 2}, {0, 0, 1}, everywhere, noise_texture(0.03, 5)}}, centres,
                             {0.1, 1.2});
}

TEST(DepthChoice, WithoutPointsThePhotographsTellWhatIsEnough) {
    // Without points a plane stands at the wrong depth.
    EXPECT_EQ(chosen(wall_without_points(cross_of_centres(0.12))), "sweep");
}

TEST(DepthChoice, WhereNothingCanBeKeptBackTakesTheSweepAndSaysWhy) {
    const KnownDepthScene known = wall_without_points({{0, 0, 0}, {0.12, 0, 0}});
    SilentProgress progress;
    const DepthChoice choice =
        choose_depth_model(known.scene, no_masks(known), "refined_sweep", 1, progress);
    EXPECT_EQ(choice.model, "sweep");
    EXPECT_NE(choice.explanation.find("no view has two neighbours"), std::string::npos)
        << choice.explanation;
}

}  // namespace
}  // namespace lumi
