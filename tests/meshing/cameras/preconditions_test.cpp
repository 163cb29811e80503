#include "meshing/cameras/preconditions.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "calib/capture/degrees.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

TEST(Preconditions, AskWhoFacesTheMiddleOrWhatLiesOppositeOfIt) {
    // On a ring, looking in, along it, and out.
    for (const double turn_deg : {0.0, 90.0, 180.0}) {
        Capture capture;
        capture.cameras.push_back(pinhole_camera(640, 480, 500));
        for (int i = 0; i < 12; ++i) {
            View view;
            view.name = std::to_string(i);
            view.cam_from_world.rotation = Eigen::AngleAxisd(
                (30 * i + turn_deg) * kRadiansPerDegree, Eigen::Vector3d::UnitY());
            const double at = 30 * i * kRadiansPerDegree;
            const Eigen::Vector3d centre(3 * std::sin(at), 0, -3 * std::cos(at));
            view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
            capture.views.push_back(view);
        }
        const auto axes = optical_axes(capture, all_views(capture));
        EXPECT_EQ(share_that_faces(capture, axes, {0, 0, 0}, false), turn_deg == 0 ? 1 : 0);
        EXPECT_EQ(share_that_faces(capture, axes, {0, 0, 0}, true), turn_deg == 180 ? 1 : 0);
    }
}

TEST(Preconditions, AreMetByMostOfTheSceneAndOfTheCameras) {
    EXPECT_FALSE(why_no_surface({}).has_value());
    EXPECT_FALSE(why_no_surface({0.98, 0.9}).has_value());
    EXPECT_TRUE(why_no_surface({0.54, 1.0}).has_value());
    EXPECT_TRUE(why_no_surface({1.0, 0.52}).has_value());
}

}  // namespace
}  // namespace lumi
