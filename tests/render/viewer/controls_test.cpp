#include "render/viewer/controls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "render/paths/photograph_eye.h"
#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

/// An upright eye at (0.5, 1, -4) that looks a little down and to the left, world up is -y.
Navigation some_navigation() {
    const Eigen::Vector3d up = -Eigen::Vector3d::UnitY();
    const Eigen::Vector3d eye(0.5, 1.0, -4.0);
    const Eigen::Vector3d forward = Eigen::Vector3d(-0.2, 0.15, 1.0).normalized();
    const Eigen::Vector3d right = forward.cross(up).normalized();
    Eigen::Matrix3d cam_from_world;
    cam_from_world << right.transpose(), forward.cross(right).transpose(), forward.transpose();
    Navigation navigation;
    navigation.eye = {{800, 600, LensModel::kPinhole, {700.0, 710.0, 390.0, 310.0}},
                      {Eigen::Quaterniond(cam_from_world), -cam_from_world * eye}};
    navigation.pivot_in_world = eye + 4.5 * forward + 0.3 * right;
    navigation.up_in_world = up;
    return navigation;
}

Eigen::Vector3d place(const Navigation& n) { return centre_in_world(n.eye.cam_from_world); }
Eigen::Vector3d gaze(const Navigation& n) { return optical_axis_in_world(n.eye.cam_from_world); }
Eigen::Vector3d picture_up(const Navigation& n) {
    return n.eye.cam_from_world.rotation.conjugate() * -Eigen::Vector3d::UnitY();
}
double distance(const Navigation& n) { return (place(n) - n.pivot_in_world).norm(); }
Eigen::Vector2d pixel_of(const Navigation& n, const Eigen::Vector3d& point) {
    return project(n.eye.camera, n.eye.cam_from_world * point).value();
}
double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(SomeNavigation, IsUpright) {
    EXPECT_GT(picture_up(some_navigation()).dot(some_navigation().up_in_world), 0.9);
}

TEST(Orbit, KeepsTheDistanceToThePivotAndItsPixel) {
    Navigation navigation = some_navigation();
    const double before = distance(navigation);
    const Eigen::Vector2d pixel = pixel_of(navigation, navigation.pivot_in_world);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> drag(-150, 150);
    for (int step = 0; step < 200; ++step) {
        navigation = orbit(navigation, {drag(random), drag(random)});
        EXPECT_NEAR(distance(navigation), before, 1e-9);
        EXPECT_LT((pixel_of(navigation, navigation.pivot_in_world) - pixel).norm(), 1e-6);
        EXPECT_NEAR(navigation.eye.cam_from_world.rotation.norm(), 1.0, 1e-12);
    }
}

TEST(Orbit, TurnsHalfWayForTheHeightOfThePicture) {
    const Navigation before = some_navigation();
    const Navigation after = orbit(before, {600.0, 0.0});
    const Eigen::Vector3d up = before.up_in_world;
    const auto level = [&](const Eigen::Vector3d& v) { return (v - v.dot(up) * up).eval(); };
    const Eigen::Vector3d arm_before = place(before) - before.pivot_in_world;
    const Eigen::Vector3d arm_after = place(after) - after.pivot_in_world;
    EXPECT_LT((level(arm_after) + level(arm_before)).norm(), 1e-9) << "opposite side";
    EXPECT_NEAR(arm_after.dot(up), arm_before.dot(up), 1e-9) << "same height";
}

TEST(Orbit, ComesBackWhenTheDragComesBack) {
    const Navigation before = some_navigation();
    const Navigation after = orbit(orbit(before, {123.0, 45.0}), {-123.0, -45.0});
    EXPECT_LT((place(after) - place(before)).norm(), 1e-9);
    EXPECT_LT((gaze(after) - gaze(before)).norm(), 1e-9);
}

TEST(Orbit, LetsTheNearSideOfTheSceneFollowTheCursor) {
    const Navigation before = some_navigation();
    const Eigen::Vector3d near_side = before.pivot_in_world - 0.5 * gaze(before);
    const Eigen::Vector2d right = pixel_of(orbit(before, {20.0, 0.0}), near_side);
    const Eigen::Vector2d down = pixel_of(orbit(before, {0.0, 20.0}), near_side);
    EXPECT_GT(right.x(), pixel_of(before, near_side).x() + 1);
    EXPECT_GT(down.y(), pixel_of(before, near_side).y() + 1);
}

TEST(Orbit, NeverTurnsTheWorldUpsideDown) {
    for (const double drag : {-40.0, 40.0, -500.0, 500.0}) {
        Navigation navigation = some_navigation();
        for (int step = 0; step < 100; ++step) {
            navigation = orbit(navigation, {3.0, drag});
            EXPECT_GT(picture_up(navigation).dot(navigation.up_in_world), 0.0);
        }
    }
}

TEST(Look, KeepsThePlaceAndLetsTheSceneFollowTheCursor) {
    const Navigation before = some_navigation();
    const Eigen::Vector3d far_point = place(before) + 100 * gaze(before);
    const Navigation after = look(before, {30.0, -20.0});
    EXPECT_LT((place(after) - place(before)).norm(), 1e-12);
    EXPECT_NEAR(distance(after), distance(before), 1e-9);
    const Eigen::Vector2d way = pixel_of(after, far_point) - pixel_of(before, far_point);
    EXPECT_NEAR(way.x(), 30.0, 1.0);
    EXPECT_NEAR(way.y(), -20.0, 1.0);
}

TEST(Pan, MovesParallelToTheImagePlaneWithoutTurning) {
    const Navigation before = some_navigation();
    const Navigation after = pan(before, {57.0, -31.0});
    EXPECT_NEAR((place(after) - place(before)).dot(gaze(before)), 0.0, 1e-12);
    EXPECT_EQ(after.eye.cam_from_world.rotation.coeffs(),
              before.eye.cam_from_world.rotation.coeffs());
}

TEST(Pan, MovesThePivotsPlaceInTheSceneExactlyWithTheCursor) {
    const Navigation before = some_navigation();
    const Navigation after = pan(before, {57.0, -31.0});
    const Eigen::Vector2d way =
        pixel_of(after, before.pivot_in_world) - pixel_of(before, before.pivot_in_world);
    EXPECT_LT((way - Eigen::Vector2d(57.0, -31.0)).norm(), 1e-9);
    EXPECT_LT(
        (pixel_of(after, after.pivot_in_world) - pixel_of(before, before.pivot_in_world)).norm(),
        1e-9)
        << "the pivot moves along";
}

TEST(Zoom, ComesATenthCloserAStepAndKeepsThePivotsPixel) {
    const Navigation before = some_navigation();
    const Navigation after = zoom(before, 3.0);
    EXPECT_NEAR(distance(after), 0.729 * distance(before), 1e-12);
    EXPECT_LT(
        (pixel_of(after, before.pivot_in_world) - pixel_of(before, before.pivot_in_world)).norm(),
        1e-9);
    EXPECT_LT((place(zoom(after, -3.0)) - place(before)).norm(), 1e-12);
}

TEST(Zoom, NeverReachesThePivot) {
    Navigation navigation = some_navigation();
    for (int step = 0; step < 50; ++step) navigation = zoom(navigation, 5.0);
    EXPECT_GT(distance(navigation), 0.0);
    EXPECT_TRUE(place(navigation).allFinite());
}

TEST(Zoom, PushesThePivotOnOnceItIsAsNearAsTheLeastDistance) {
    Navigation before = some_navigation();
    before.least_distance = 0.5;
    const Eigen::Vector3d direction = (before.pivot_in_world - place(before)).normalized();
    Navigation after = before;
    for (int step = 0; step < 40; ++step) {
        const Navigation last = after;
        after = zoom(after, 1.0);
        const double way = (place(after) - place(last)).dot(direction);
        EXPECT_GT(way, 0.1 * before.least_distance - 1e-12);
        EXPECT_LT((place(after) - place(last) - way * direction).norm(), 1e-9) << "straight ahead";
    }
    EXPECT_NEAR(distance(after), before.least_distance, 1e-9);
    EXPECT_GT((place(after) - before.pivot_in_world).dot(direction), 0.0) << "through the pivot";
    EXPECT_LT(
        (pixel_of(after, after.pivot_in_world) - pixel_of(before, before.pivot_in_world)).norm(),
        1e-9);
    // At once or step by step, it is the same way but for the step that reaches the distance.
    EXPECT_LT((place(zoom(before, 40.0)) - place(after)).norm(), 0.05 * before.least_distance);
    EXPECT_GT(distance(zoom(after, -1.0)), distance(after)) << "and back";
}

TEST(Zoom, KeepsAPivotThatIsNearerThanTheLeastDistanceAsNear) {
    Navigation near = some_navigation();
    near.least_distance = 10.0;
    const Navigation after = zoom(near, 2.0);
    EXPECT_NEAR(distance(after), distance(near), 1e-9);
    EXPECT_NEAR((place(after) - place(near)).norm(), 2.0, 1e-9);
}

TEST(Fly, IsNoSlowerThanByTheLeastDistance) {
    Navigation near = zoom(some_navigation(), 40.0);
    near.least_distance = 0.5;
    EXPECT_NEAR((place(fly(near, {0, 0, 1})) - place(near)).norm(), 0.5, 1e-9);
    Navigation far = some_navigation();
    far.least_distance = 0.5;
    EXPECT_NEAR((place(fly(far, {0, 0, 1})) - place(far)).norm(), distance(far), 1e-9);
}

TEST(LeastDistance, IsAThirdOfWhereTheSceneBegins) {
    Lumigraph lumigraph = tiny_lumigraph();
    lumigraph.near_depth = 6.0;
    lumigraph.far_depth = 20.0;
    EXPECT_NEAR(least_distance(lumigraph), 2.0, 1e-12);
    lumigraph.near_depth = lumigraph.far_depth = 0.0;
    EXPECT_GT(least_distance(lumigraph), 0.0);
    EXPECT_TRUE(std::isfinite(least_distance(lumigraph)));
}

TEST(Fly, MovesAlongTheEyesOwnAxesByTheDistanceToThePivot) {
    const Navigation before = some_navigation();
    const Navigation forward = fly(before, {0, 0, 0.5});
    EXPECT_LT((place(forward) - place(before) - 0.5 * distance(before) * gaze(before)).norm(),
              1e-12);
    const Navigation up = fly(before, {0, -0.25, 0});
    EXPECT_LT((place(up) - place(before) - 0.25 * distance(before) * picture_up(before)).norm(),
              1e-12);
    EXPECT_NEAR(distance(forward), distance(before), 1e-12);
}

TEST(CarriedTo, TurnsAboutWhatIsStraightAheadAsFarAwayAsBefore) {
    const Navigation before = some_navigation();
    Eye eye = before.eye;
    eye.cam_from_world = {Eigen::Quaterniond(Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitY())),
                          {7.0, -3.0, 1.0}};
    const Navigation after = carried_to(before, eye);
    EXPECT_LT((place(after) - centre_in_world(eye.cam_from_world)).norm(), 1e-12);
    EXPECT_NEAR(distance(after), distance(before), 1e-9);
    EXPECT_LT(angle(after.pivot_in_world - place(after), gaze(after)), 1e-9);
}

TEST(SnapTo, StandsWhereThePhotographWasTaken) {
    const Lumigraph lumigraph = tiny_lumigraph();
    for (int i = 0; i < 3; ++i) {
        const Navigation snapped = snap_to(some_navigation(), lumigraph, i);
        const Eye expected = eye_at(lumigraph.views[static_cast<std::size_t>(i)]);
        EXPECT_EQ(snapped.eye.camera, expected.camera);
        EXPECT_EQ(snapped.eye.cam_from_world.rotation.coeffs(),
                  expected.cam_from_world.rotation.coeffs());
        EXPECT_EQ(snapped.eye.cam_from_world.translation, expected.cam_from_world.translation);
        EXPECT_EQ(nearest_view(lumigraph, snapped.eye), i);
    }
    EXPECT_THROW(static_cast<void>(snap_to(some_navigation(), lumigraph, 3)), std::out_of_range);
}

TEST(SnapTo, TurnsAboutWhatTheMiddleOfThePhotographShows) {
    Lumigraph lumigraph = tiny_lumigraph();
    LumigraphView& view = lumigraph.views[0];
    view.cam_from_world.translation = {0.1, 0.2, 0.3};
    view.depth.inverse_depth = FloatImage(5, 5, 0.125F);
    view.depth.confidence = GrayImage(5, 5, 255);
    const Navigation snapped = snap_to(some_navigation(), lumigraph, 0);
    const Eigen::Vector3d pivot_in_cam = view.cam_from_world * snapped.pivot_in_world;
    EXPECT_NEAR(pivot_in_cam.z(), 8.0, 1e-9);
    EXPECT_LT((project(view.camera, pivot_in_cam).value() -
               Eigen::Vector2d(0.5 * view.camera.width_px, 0.5 * view.camera.height_px))
                  .norm(),
              1e-9);
}

TEST(FrameAll, ShowsTheWholeBallAndNotMuchMore) {
    const SceneBounds bounds{{3.0, -2.0, 7.0}, 1.7};
    const Navigation framed = frame_all(some_navigation(), bounds);
    EXPECT_LT((gaze(framed) - gaze(some_navigation())).norm(), 1e-12) << "it must not turn";
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    double nearest_to_side_px = 1e9;
    for (int i = 0; i < 20'000; ++i) {
        const Eigen::Vector3d direction =
            Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
        const Eigen::Vector2d pixel =
            pixel_of(framed, bounds.centre_in_world + bounds.radius * direction);
        ASSERT_TRUE(is_inside(framed.eye.camera, pixel)) << pixel.transpose();
        nearest_to_side_px =
            std::min({nearest_to_side_px, pixel.x(), pixel.y(), 800 - pixel.x(), 600 - pixel.y()});
    }
    EXPECT_LT(nearest_to_side_px, 2.0) << "the ball touches a side";
    EXPECT_LT(angle(bounds.centre_in_world - place(framed), gaze(framed)), 1e-9);
}

}  // namespace
}  // namespace lumi
