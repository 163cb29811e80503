#include "calib/mapping/incremental_mapper.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "calib/mapping/before_placement.h"
#include "calib/mapping/model_adjustment.h"
#include "calib/mapping/two_view_start.h"
#include "calib/work/error.h"
#include "tests/calib/interrupted_progress.h"
#include "tests/calib/mapping/matched_scene.h"

namespace lumi {
namespace {

SyntheticCaptureOptions arc(int views, double noise_px = 0) {
    SyntheticCaptureOptions options;
    options.views = views;
    options.points = 400;
    options.noise_px = noise_px;
    options.arc_deg = 90;
    return options;
}

GrowingModel mapped(const MatchedScene& scene, IncrementalMappingOptions options = {}) {
    SilentProgress progress;
    GrowingModel model = unplaced_model(scene.cameras, scene.photographs, scene.pairs);
    map_from_start(
        model, scene.pairs, options, [](int) {}, progress);
    return model;
}

TEST(TwoViewStart, TakesThePairWithTheWidestAngles) {
    const MatchedScene scene =
        matched_scene(synthetic_capture(pinhole_camera(1000, 800, 900), arc(6)));
    const GrowingModel model = unplaced_model(scene.cameras, scene.photographs, scene.pairs);
    const auto starts = two_view_starts(model, scene.pairs, {});
    ASSERT_FALSE(starts.empty());
    const auto pose = [&](int view) {
        return scene.truth.views[static_cast<std::size_t>(view)].cam_from_world;
    };
    const Rigid3 truth = pose(starts[0].second) * inverse(pose(starts[0].first));
    EXPECT_LT(starts[0].second_from_first.rotation.angularDistance(truth.rotation), 1e-3);
    EXPECT_LT((starts[0].second_from_first.translation - truth.translation.normalized()).norm(),
              5e-3);
    EXPECT_GE(starts[0].second - starts[0].first, 2);
}

TEST(TwoViewStart, HasNoneWhereTheCameraOnlyTurned) {
    Capture truth = synthetic_capture(pinhole_camera(1000, 800, 900), arc(4));
    const Rigid3 first = truth.views[0].cam_from_world;
    const Eigen::Vector3d centre = centre_in_world(first);
    double turn_rad = 0;
    for (View& view : truth.views) {
        view.cam_from_world.rotation =
            Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY()) * first.rotation;
        turn_rad += 0.05;
        view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
    }
    for (ScenePoint& point : truth.points) {
        for (Observation& seen : point.track) {
            const View& view = truth.views[static_cast<std::size_t>(seen.view_index)];
            seen.pixel =
                project(truth.cameras[0], view.cam_from_world * point.position_in_world).value();
        }
    }
    const MatchedScene scene = matched_scene(std::move(truth));
    const GrowingModel model = unplaced_model(scene.cameras, scene.photographs, scene.pairs);
    EXPECT_TRUE(two_view_starts(model, scene.pairs, {}).empty());
}

/// To the pairs of photograph 0 as many matches again: of features that nothing else is matched
/// with, to such that are matched with another feature of it already. No track takes them.
MatchedScene with_matches_that_contradict(MatchedScene scene) {
    auto& keypoints = scene.photographs[0].keypoints_px;
    const auto features = static_cast<std::uint32_t>(keypoints.size());
    for (std::uint32_t feature = 0; feature < features; ++feature) {
        keypoints.push_back(keypoints[feature] + Eigen::Vector2f(7, -5));
    }
    for (VerifiedPair& pair : scene.pairs) {
        if (pair.first != 0) continue;
        for (const FeatureMatch& match : std::vector<FeatureMatch>(pair.inliers)) {
            pair.inliers.push_back({match.first + features, match.second});
        }
    }
    return scene;
}

TEST(TwoViewStart, LooksOnlyAtMatchesOfFeaturesThatATrackUses) {
    const MatchedScene scene =
        matched_scene(synthetic_capture(pinhole_camera(1000, 800, 900), arc(2)));
    const MatchedScene more = with_matches_that_contradict(scene);
    const auto starts_of = [](const MatchedScene& matched) {
        return two_view_starts(unplaced_model(matched.cameras, matched.photographs, matched.pairs),
                               matched.pairs, {});
    };
    const std::vector<TwoViewStart> plain = starts_of(scene);
    const std::vector<TwoViewStart> contradicted = starts_of(more);
    ASSERT_EQ(plain.size(), 1u);
    ASSERT_EQ(contradicted.size(), 1u);
    EXPECT_EQ(contradicted[0].weight, plain[0].weight);
    EXPECT_EQ(contradicted[0].second_from_first.translation,
              plain[0].second_from_first.translation);
}

TEST(IncrementalMapper, FindsExactPosesOfAnExactScene) {
    const MatchedScene scene =
        matched_scene(synthetic_capture(pinhole_camera(1000, 800, 900), arc(10)));
    IncrementalMappingOptions options;
    options.refine_lenses = false;
    const GrowingModel model = mapped(scene, options);
    EXPECT_EQ(model.placed(), 10);
    const Capture capture = capture_of(model, names_of(scene.truth));
    // Pixels are kept in single precision.
    EXPECT_LT(relative_position_error(capture, scene.truth), 1e-5);
    EXPECT_EQ(capture.cameras, scene.truth.cameras);
}

TEST(IncrementalMapper, HoldsOutAgainstFalseMatches) {
    MatchedScene scene =
        matched_scene(synthetic_capture(pinhole_camera(1000, 800, 900), arc(10, 0.5)));
    confuse_matches(scene, 0.2, 3);
    const GrowingModel model = mapped(scene);
    EXPECT_EQ(model.placed(), 10);
    const Capture capture = capture_of(model, names_of(scene.truth));
    EXPECT_LT(relative_position_error(capture, scene.truth), 0.01);
}

TEST(IncrementalMapper, FindsTheFocalLengthFromAGuess) {
    MatchedScene scene = matched_scene(
        synthetic_capture({1000, 800, LensModel::kSimpleRadial, {900, 500, 400, -0.1}}, arc(10)));
    scene.cameras[0].camera.parameters = {1200, 500, 400, 0};
    const GrowingModel model = mapped(scene);
    EXPECT_EQ(model.placed(), 10);
    EXPECT_NEAR(model.cameras[0].parameters[0], 900, 5);
    EXPECT_NEAR(model.cameras[0].parameters[3], -0.1, 0.01);
}

TEST(IncrementalMapper, TriesOtherFocalLengthsForAnotherCamera) {
    Capture truth = synthetic_capture(pinhole_camera(1000, 800, 900), arc(10));
    truth.cameras.push_back(pinhole_camera(1000, 800, 1400));
    for (ScenePoint& point : truth.points) {
        for (Observation& seen : point.track) {
            if (seen.view_index != 9) continue;
            const View& view = truth.views[9];
            seen.pixel =
                project(truth.cameras[1], view.cam_from_world * point.position_in_world).value();
        }
    }
    truth.views[9].camera_index = 1;
    MatchedScene scene = matched_scene(std::move(truth));
    scene.cameras[1].camera = pinhole_camera(1000, 800, 900);
    IncrementalMappingOptions options;
    options.focal_length_is_guessed = {0, 1};
    const GrowingModel model = mapped(scene, options);
    EXPECT_EQ(model.placed(), 10);
    EXPECT_NEAR(model.cameras[1].parameters[0], 1400, 10);
}

/// A model of all photographs but the last as they truly are, with what these see.
GrowingModel without_the_last(const MatchedScene& scene) {
    GrowingModel model = unplaced_model(scene.cameras, scene.photographs, scene.pairs);
    for (std::size_t view = 0; view + 1 < scene.truth.views.size(); ++view) {
        model.is_placed[view] = 1;
        model.cam_from_world[view] = scene.truth.views[view].cam_from_world;
    }
    triangulate_all_tracks(model, {});
    return model;
}

/// The last photograph is of a camera of its own, of which a guess is told, and noisier than a
/// model of exact sightings lets in.
MatchedScene scene_with_a_noisy_last_photograph() {
    Capture truth = synthetic_capture(pinhole_camera(1000, 800, 900), arc(8));
    truth.cameras.push_back(pinhole_camera(1000, 800, 1400));
    double offset_px = 1.5;
    for (ScenePoint& point : truth.points) {
        for (Observation& seen : point.track) {
            if (seen.view_index != 7) continue;
            const View& view = truth.views[7];
            seen.pixel =
                project(truth.cameras[1], view.cam_from_world * point.position_in_world).value();
            seen.pixel += Eigen::Vector2d(offset_px, -0.7 * offset_px);
            offset_px = -offset_px;
        }
    }
    truth.views[7].camera_index = 1;
    MatchedScene scene = matched_scene(std::move(truth));
    scene.cameras[1].camera = pinhole_camera(1000, 800, 900);
    return scene;
}

TEST(IncrementalMapper, LeavesTheGuessOfALensWhosePhotographCannotBePlaced) {
    const MatchedScene scene = scene_with_a_noisy_last_photograph();
    IncrementalMappingOptions options;
    options.focal_length_is_guessed = {0, 1};
    options.refine_lenses = false;
    options.max_error_px = 0.02;
    GrowingModel model = without_the_last(scene);
    SilentProgress progress;
    grow_model(
        model, options, [](int) {}, progress);
    ASSERT_EQ(model.placed(), 7);
    EXPECT_EQ(model.cameras[1], scene.cameras[1].camera);
    const GrowingModel unplaced = unplaced_model(scene.cameras, scene.photographs, scene.pairs);
    EXPECT_TRUE(model.rays[7] == unplaced.rays[7]);
    // With looser limits it is placed, under another focal length.
    options.max_error_px = 4;
    model = without_the_last(scene);
    grow_model(
        model, options, [](int) {}, progress);
    EXPECT_EQ(model.placed(), 8);
    EXPECT_NE(model.cameras[1], scene.cameras[1].camera);
}

/// Of the first so many photographs, to the bit.
bool have_same_poses(const GrowingModel& a, const GrowingModel& b, std::size_t photographs) {
    for (std::size_t index = 0; index < photographs; ++index) {
        if (a.cam_from_world[index].translation != b.cam_from_world[index].translation ||
            a.cam_from_world[index].rotation.coeffs() !=
                b.cam_from_world[index].rotation.coeffs()) {
            return false;
        }
    }
    return true;
}

TEST(BeforePlacement, RestoresAllThatAPlacementChanged) {
    const MatchedScene scene = scene_with_a_noisy_last_photograph();
    const GrowingModel model = without_the_last(scene);
    GrowingModel changed = model;
    const BeforePlacement before(changed, 7);
    changed.cameras[1] = scene.truth.cameras[1];
    update_rays(changed);
    changed.is_placed[7] = 1;
    changed.cam_from_world[7] = scene.truth.views[7].cam_from_world;
    triangulate_tracks(changed, tracks_of(changed, 7), {});
    SilentProgress progress;
    adjust_around(changed, 7, {}, progress);
    ASSERT_FALSE(have_same_poses(changed, model, 7));
    ASSERT_FALSE(changed.tracks == model.tracks);
    before.restore(changed);
    EXPECT_EQ(changed.cameras, model.cameras);
    EXPECT_TRUE(changed.rays == model.rays);
    EXPECT_EQ(changed.is_placed, model.is_placed);
    EXPECT_TRUE(changed.tracks == model.tracks);
    EXPECT_TRUE(have_same_poses(changed, model, 8));
}

TEST(IncrementalMapper, KeepsTheLargerOfTwoPartsThatNothingConnects) {
    MatchedScene scene = matched_scene(synthetic_capture(pinhole_camera(1000, 800, 900), arc(10)));
    std::erase_if(scene.pairs,
                  [](const VerifiedPair& pair) { return pair.first < 4 && pair.second >= 4; });
    const GrowingModel model = mapped(scene);
    EXPECT_EQ(model.placed(), 6);
    EXPECT_EQ(model.is_placed[0], 0);
    EXPECT_EQ(model.is_placed[9], 1);
}

TEST(IncrementalMapper, IsTheSameInEveryRun) {
    MatchedScene scene =
        matched_scene(synthetic_capture(pinhole_camera(1000, 800, 900), arc(8, 0.5)));
    confuse_matches(scene, 0.1, 3);
    const GrowingModel once = mapped(scene);
    const GrowingModel again = mapped(scene);
    for (std::size_t index = 0; index < 8; ++index) {
        EXPECT_EQ(once.cam_from_world[index].translation, again.cam_from_world[index].translation);
    }
    EXPECT_EQ(once.cameras, again.cameras);
    EXPECT_TRUE(once.tracks == again.tracks);
}

/// What the views see of the points, exactly.
void see_again(Capture& capture) {
    for (ScenePoint& point : capture.points) {
        for (Observation& seen : point.track) {
            const View& view = capture.views[static_cast<std::size_t>(seen.view_index)];
            seen.pixel =
                project(camera_of(capture, view), view.cam_from_world * point.position_in_world)
                    .value();
        }
    }
}

/// From so near to one another that rays meet at 3 degrees and less.
Capture shallow_capture(int views) {
    SyntheticCaptureOptions options = arc(views);
    options.arc_deg = 3;
    options.arc_radius = 8;
    Capture capture = synthetic_capture(pinhole_camera(1000, 800, 2400), options);
    for (View& view : capture.views) {  // Also the heights differ by little.
        Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
        centre.y() *= 0.05;
        view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
    }
    see_again(capture);
    return capture;
}

TEST(IncrementalMapper, BeginsWithLittleParallaxWhereThereIsNoMore) {
    IncrementalMappingOptions mapping;
    mapping.refine_lenses = false;
    const MatchedScene scene = matched_scene(shallow_capture(6));
    const GrowingModel model = mapped(scene, mapping);
    EXPECT_EQ(model.placed(), 6);
    EXPECT_LT(relative_position_error(capture_of(model, names_of(scene.truth)), scene.truth), 1e-3);
}

/// Appended to photographs that share nothing with them: two with a wide angle between them.
void append_wide_pair(MatchedScene& scene, int points) {
    const int first = static_cast<int>(scene.photographs.size());
    SyntheticCaptureOptions wide = arc(2);
    wide.points = points;
    wide.arc_radius = 8;
    wide.arc_deg = 20;
    const MatchedScene pair =
        matched_scene(synthetic_capture(pinhole_camera(1000, 800, 2400), wide));
    scene.photographs.insert(scene.photographs.end(), pair.photographs.begin(),
                             pair.photographs.end());
    for (VerifiedPair more : pair.pairs) {
        more.first += first;
        more.second += first;
        scene.pairs.push_back(std::move(more));
    }
}

TEST(IncrementalMapper, BeginsWithLittleParallaxWhereAWideStartPlacesNothingElse) {
    IncrementalMappingOptions mapping;
    mapping.refine_lenses = false;
    MatchedScene scene = matched_scene(shallow_capture(6));
    append_wide_pair(scene, 400);
    EXPECT_EQ(mapped(scene, mapping).placed(), 6);
    MatchedScene pair = matched_scene(shallow_capture(6));
    pair.photographs.clear();
    pair.pairs.clear();
    append_wide_pair(pair, 400);
    EXPECT_EQ(mapped(pair, mapping).placed(), 2);
}

TEST(IncrementalMapper, OfTwoPairsKeepsTheOneWithParallaxThoughItSharesFewerPoints) {
    IncrementalMappingOptions mapping;
    mapping.refine_lenses = false;
    MatchedScene scene = matched_scene(shallow_capture(2));
    append_wide_pair(scene, 200);
    const GrowingModel model = mapped(scene, mapping);
    EXPECT_EQ(model.placed(), 2);
    EXPECT_EQ(model.is_placed[2], 1);
    EXPECT_EQ(model.is_placed[3], 1);
}

/// Six photographs with little parallax, and one from far aside. It is matched with the second one
/// by mistakes, and with the first one rightly, but less often: no track takes these matches.
MatchedScene scene_with_a_wide_pair_that_tracks_deny() {
    Capture truth = shallow_capture(7);
    Rigid3& aside = truth.views[6].cam_from_world;
    aside = aside * Rigid3{Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY())),
                           Eigen::Vector3d::Zero()};
    see_again(truth);
    MatchedScene scene = matched_scene(std::move(truth));
    std::erase_if(scene.pairs,
                  [](const VerifiedPair& pair) { return pair.second == 6 && pair.first > 1; });
    for (VerifiedPair& pair : scene.pairs) {
        if (pair.second != 6) continue;
        if (pair.first == 0) {
            pair.inliers.resize(100);
            continue;
        }
        const std::vector<FeatureMatch> right = pair.inliers;
        for (std::size_t index = 0; index < right.size(); ++index) {
            pair.inliers[index].second = right[(index + 1) % right.size()].second;
        }
    }
    return scene;
}

TEST(IncrementalMapper, BeginsWithLittleParallaxWhereThePairsWithMoreLeadNowhere) {
    const MatchedScene scene = scene_with_a_wide_pair_that_tracks_deny();
    const GrowingModel unplaced = unplaced_model(scene.cameras, scene.photographs, scene.pairs);
    ASSERT_EQ(two_view_starts(unplaced, scene.pairs, {}).size(), 1u);
    IncrementalMappingOptions mapping;
    mapping.refine_lenses = false;
    const GrowingModel model = mapped(scene, mapping);
    EXPECT_EQ(model.placed(), 6);
    EXPECT_EQ(model.is_placed[6], 0);
}

TEST(IncrementalMapper, CountsOnlyStartsThatLeadSomewhere) {
    IncrementalMappingOptions mapping;
    mapping.refine_lenses = false;
    mapping.starts = 1;
    EXPECT_EQ(mapped(scene_with_a_wide_pair_that_tracks_deny(), mapping).placed(), 6);
}

TEST(IncrementalMapper, BeginsWithNoPhotographThatIsPlacedAlready) {
    const MatchedScene scene =
        matched_scene(synthetic_capture(pinhole_camera(1000, 800, 900), arc(5)));
    GrowingModel model = unplaced_model(scene.cameras, scene.photographs, scene.pairs);
    model.is_placed[0] = 1;
    SilentProgress progress;
    EXPECT_THROW(map_from_start(
                     model, scene.pairs, {}, [](int) {}, progress),
                 std::invalid_argument);
}

TEST(ModelAdjustment, StopsBetweenTwoStepsOnRequest) {
    const MatchedScene scene =
        matched_scene(synthetic_capture(pinhole_camera(1000, 800, 900), arc(6, 0.5)));
    GrowingModel model = without_the_last(scene);
    InterruptedProgress progress(2);
    EXPECT_THROW(adjust_model(model, {}, progress), Error);
}

TEST(IncrementalMapper, PlacesNothingWithoutAStart) {
    MatchedScene scene = matched_scene(synthetic_capture(pinhole_camera(1000, 800, 900), arc(5)));
    scene.pairs.clear();
    EXPECT_EQ(mapped(scene).placed(), 0);
}

}  // namespace
}  // namespace lumi
