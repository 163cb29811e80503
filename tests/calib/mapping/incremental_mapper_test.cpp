#include "calib/mapping/incremental_mapper.h"

#include <gtest/gtest.h>

#include "calib/mapping/two_view_start.h"
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
    EXPECT_EQ(once.points_in_world, again.points_in_world);
}

TEST(IncrementalMapper, BeginsWithLittleParallaxWhereThereIsNoMore) {
    SyntheticCaptureOptions options = arc(6);
    options.arc_deg = 3;
    options.arc_radius = 8;
    Capture truth = synthetic_capture(pinhole_camera(1000, 800, 2400), options);
    for (View& view : truth.views) {  // Also the heights differ by little.
        Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
        centre.y() *= 0.05;
        view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
    }
    for (ScenePoint& point : truth.points) {
        for (Observation& seen : point.track) {
            const View& view = truth.views[static_cast<std::size_t>(seen.view_index)];
            seen.pixel =
                project(truth.cameras[0], view.cam_from_world * point.position_in_world).value();
        }
    }
    IncrementalMappingOptions mapping;
    mapping.refine_lenses = false;
    const MatchedScene scene = matched_scene(std::move(truth));
    const GrowingModel model = mapped(scene, mapping);
    EXPECT_EQ(model.placed(), 6);
    EXPECT_LT(relative_position_error(capture_of(model, names_of(scene.truth)), scene.truth), 1e-3);
}

TEST(IncrementalMapper, PlacesNothingWithoutAStart) {
    MatchedScene scene = matched_scene(synthetic_capture(pinhole_camera(1000, 800, 900), arc(5)));
    scene.pairs.clear();
    EXPECT_EQ(mapped(scene).placed(), 0);
}

}  // namespace
}  // namespace lumi
