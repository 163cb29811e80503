#include "render/paths/photograph_eye.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "calib/capture/rigid3.h"
#include "calib/work/error.h"
#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

/// A lens off the middle of a picture that is not square, anywhere.
Eye some_eye() {
    return {{640, 480, LensModel::kPinhole, {500.0, 510.0, 300.0, 260.0}},
            {Eigen::Quaterniond(0.8, 0.1, -0.5, 0.2).normalized(), {0.3, -0.2, 0.7}}};
}

Eigen::Vector3d point_seen_at(const Eye& eye, const Eigen::Vector2d& pixel, double depth) {
    return inverse(eye.cam_from_world) * Eigen::Vector3d(depth * unproject(eye.camera, pixel));
}

Eigen::Vector2d pixel_of(const Eye& eye, const Eigen::Vector3d& point_in_world) {
    return project(eye.camera, eye.cam_from_world * point_in_world).value();
}

TEST(TurnedUpright, MovesPixelsAsTheExifStandardSays) {
    const Eye eye = some_eye();
    for (const Eigen::Vector2d& pixel :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(640, 0), Eigen::Vector2d(100.5, 333.25)}) {
        const Eigen::Vector3d point = point_seen_at(eye, pixel, 2.5);
        const double x = pixel.x();
        const double y = pixel.y();
        const auto turned = [&](int orientation) {
            return pixel_of(turned_upright(eye, orientation), point);
        };
        EXPECT_LT((turned(1) - Eigen::Vector2d(x, y)).norm(), 1e-9);
        EXPECT_LT((turned(3) - Eigen::Vector2d(640 - x, 480 - y)).norm(), 1e-9);
        EXPECT_LT((turned(6) - Eigen::Vector2d(480 - y, x)).norm(), 1e-9);
        EXPECT_LT((turned(8) - Eigen::Vector2d(y, 640 - x)).norm(), 1e-9);
    }
}

TEST(TurnedUpright, SwapsWidthAndHeightForQuarterTurnsOnly) {
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Camera camera = turned_upright(some_eye(), orientation).camera;
        EXPECT_EQ(camera.width_px, orientation >= 5 ? 480 : 640) << orientation;
        EXPECT_EQ(camera.height_px, orientation >= 5 ? 640 : 480) << orientation;
    }
}

TEST(TurnedUpright, NeverMovesTheEyeOrItsGaze) {
    const Eye eye = some_eye();
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Rigid3 pose = turned_upright(eye, orientation).cam_from_world;
        EXPECT_LT((centre_in_world(pose) - centre_in_world(eye.cam_from_world)).norm(), 1e-12);
        EXPECT_LT((optical_axis_in_world(pose) - optical_axis_in_world(eye.cam_from_world)).norm(),
                  1e-12);
    }
}

TEST(EyeAt, IsTheViewItselfToTheBitWhenItWasHeldUpright) {
    LumigraphView view = tiny_lumigraph().views[0];
    view.exif_orientation = 1;
    const Eye eye = eye_at(view);
    EXPECT_EQ(eye.camera, view.camera);
    EXPECT_EQ(eye.cam_from_world.rotation.coeffs(), view.cam_from_world.rotation.coeffs());
    EXPECT_EQ(eye.cam_from_world.translation, view.cam_from_world.translation);
}

TEST(FittedTo, LeavesAFrameOfItsOwnSizeToTheBit) {
    EXPECT_EQ(fitted_to(some_eye(), 640, 480).camera, some_eye().camera);
}

TEST(FittedTo, ShowsTheWholePictureCentredAsLargeAsFits) {
    const Eye eye = some_eye();
    const Eigen::Vector3d top_left = point_seen_at(eye, {0, 0}, 1.0);
    const Eigen::Vector3d bottom_right = point_seen_at(eye, {640, 480}, 1.0);

    const Eye wide = fitted_to(eye, 1000, 240);  // Half the size, 340 pixels at either side.
    EXPECT_LT((pixel_of(wide, top_left) - Eigen::Vector2d(340, 0)).norm(), 1e-9);
    EXPECT_LT((pixel_of(wide, bottom_right) - Eigen::Vector2d(660, 240)).norm(), 1e-9);

    const Eye tall = fitted_to(eye, 1280, 1160);  // Twice the size, 100 pixels above and below.
    EXPECT_LT((pixel_of(tall, top_left) - Eigen::Vector2d(0, 100)).norm(), 1e-9);
    EXPECT_LT((pixel_of(tall, bottom_right) - Eigen::Vector2d(1280, 1060)).norm(), 1e-9);
}

TEST(TurnedUpright, APictureIsTurnedAsItsEyeIs) {
    const Eye eye{pinhole_camera(6, 4, 5.0), {}};
    ColorImage picture(6, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 6; ++x)
            picture(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 0};
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Eye upright = turned_upright(eye, orientation);
        const ColorImage turned = turned_upright(picture, orientation);
        ASSERT_EQ(turned.width(), upright.camera.width_px);
        ASSERT_EQ(turned.height(), upright.camera.height_px);
        for (int y = 0; y < turned.height(); ++y)
            for (int x = 0; x < turned.width(); ++x) {
                const Eigen::Vector3d direction = upright.cam_from_world.rotation.conjugate() *
                                                  unproject(upright.camera, {x + 0.5, y + 0.5});
                const auto pixel = project(eye.camera, eye.cam_from_world.rotation * direction);
                ASSERT_TRUE(pixel.has_value());
                EXPECT_NEAR(pixel->x(), turned(x, y).r + 0.5, 1e-9) << orientation;
                EXPECT_NEAR(pixel->y(), turned(x, y).g + 0.5, 1e-9) << orientation;
            }
    }
}

TEST(IndexOfView, FindsANameOrAStemThatIsTheOnlyOne) {
    Lumigraph lumigraph = tiny_lumigraph();
    EXPECT_EQ(index_of_view(lumigraph, "set a/ünï 1.jpg"), 1);
    EXPECT_EQ(index_of_view(lumigraph, "ünï 2"), 2);
    lumigraph.views[2].name = "set b/ünï 1.jpg";
    EXPECT_EQ(index_of_view(lumigraph, "set b/ünï 1.jpg"), 2);
    EXPECT_THROW(static_cast<void>(index_of_view(lumigraph, "ünï 1")), Error) << "two of them";
    EXPECT_THROW(static_cast<void>(index_of_view(lumigraph, "ünï")), Error);
    EXPECT_THROW(static_cast<void>(index_of_view(lumigraph, "")), Error);
}

TEST(UpInWorld, IsOppositeToTheImagesYAxisOfUprightPhotographs) {
    Lumigraph lumigraph = tiny_lumigraph();
    const Eigen::Vector3d up = Eigen::Vector3d(0.2, -0.3, 0.9).normalized();
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        LumigraphView& view = lumigraph.views[i];
        const Eigen::AngleAxisd yaw(0.4 * static_cast<double>(i), Eigen::Vector3d::UnitY());
        view.exif_orientation = 1;
        view.cam_from_world.rotation =
            Eigen::Quaterniond(yaw) * turn_between(up, -Eigen::Vector3d::UnitY());
    }
    EXPECT_LT((up_in_world(lumigraph) - up).norm(), 1e-9);

    // One camera turned onto its side, and saying so, changes nothing.
    LumigraphView& view = lumigraph.views[1];
    const Eigen::AngleAxisd roll(-std::acos(0.0), Eigen::Vector3d::UnitZ());
    view.cam_from_world.rotation = Eigen::Quaterniond(roll) * view.cam_from_world.rotation;
    view.exif_orientation = 6;
    EXPECT_LT((up_in_world(lumigraph) - up).norm(), 1e-9);
}

/// A camera turned to the right, then tilted down, then rolled.
Rigid3 looking(double yaw_deg, double down_deg, double roll_deg) {
    const auto turn = [](double angle_deg, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180, axis);
    };
    return {Eigen::Quaterniond(turn(roll_deg, Eigen::Vector3d::UnitZ()) *
                               turn(down_deg, Eigen::Vector3d::UnitX()) *
                               turn(-yaw_deg, Eigen::Vector3d::UnitY())),
            Eigen::Vector3d::Zero()};
}

Eigen::Vector3d up_of(const std::vector<Rigid3>& poses) {
    Lumigraph lumigraph = tiny_lumigraph();
    lumigraph.views.resize(poses.size(), lumigraph.views.front());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        lumigraph.views[i].exif_orientation = 1;
        lumigraph.views[i].cam_from_world = poses[i];
    }
    return up_in_world(lumigraph);
}

double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

const Eigen::Vector3d kUp = -Eigen::Vector3d::UnitY();

TEST(UpInWorld, IsUprightAlsoOfCamerasThatLookDownFromOneSide) {
    // Their mean leans back by 31 degrees.
    std::vector<Rigid3> level;
    std::vector<Rigid3> by_hand;
    for (int i = 0; i < 13; ++i) {
        level.push_back(looking(10 * i - 60, 35, 0));
        by_hand.push_back(looking(10 * i - 60, 30 + i % 3 * 5, i % 2 == 0 ? 3 : -3));
    }
    EXPECT_LT(angle_deg(up_of(level), kUp), 1.5);
    EXPECT_LT(angle_deg(up_of(by_hand), kUp), 3);
}

TEST(UpInWorld, StaysTheMeanWhereCamerasLookAllOneWay) {
    const std::vector<Rigid3> alike{looking(0, 30, 0), looking(0, 10, 0), looking(0, 20, 0)};
    const Eigen::Vector3d mean = looking(0, 20, 0).rotation.conjugate() * kUp;
    EXPECT_LT(angle_deg(up_of(alike), mean), 1e-6);
}

TEST(UpInWorld, TakesNoRollsForALean) {
    // From one side, rolled by more than they look different ways: were rolls taken to be small, a
    // lean of 31 degrees would explain them.
    std::vector<Rigid3> rolled;
    for (int i = 0; i < 12; ++i)
        rolled.push_back(looking(i - 5.5, 4 * std::cos(2.0 * i), 12 * std::sin(1.0 + i)));
    EXPECT_LT(angle_deg(up_of(rolled), kUp), 6);
}

}  // namespace
}  // namespace lumi
