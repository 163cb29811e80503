#include "calib/poses/model_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/work/error.h"
#include "tests/calib/adjust/synthetic_capture.h"

namespace lumi {
namespace {

const Camera kModelCamera = pinhole_camera(1000, 800, 900);

template <class Call>
std::string refusal_of(const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kDegenerateCapture);
        EXPECT_FALSE(error.advice().empty());
        return error.code();
    }
    return "none";
}

TEST(ModelCheck, HasNothingAgainstAGoodModel) {
    EXPECT_THAT(check_model(synthetic_capture(kModelCamera, {}), false), testing::IsEmpty());
}

TEST(ModelCheck, AngleIsThatBetweenTheOutermostCameras) {
    SyntheticCaptureOptions scene;
    scene.depth_of_cloud = 0;
    scene.arc_deg = 20;
    scene.arc_radius = 100;  // Seen from afar, every point is where the middle is.
    const Camera tele = pinhole_camera(1000, 800, 20000);
    EXPECT_NEAR(median_triangulation_angle_deg(synthetic_capture(tele, scene)), 20, 1.0);
}

TEST(ModelCheck, RefusesRaysThatAreNearlyParallel) {
    SyntheticCaptureOptions scene;
    scene.views = 3;
    scene.arc_deg = 0.6;
    Capture capture = synthetic_capture(kModelCamera, scene);
    for (View& view : capture.views) {  // All at the height of the middle one.
        view.cam_from_world = capture.views[1].cam_from_world;
    }
    EXPECT_EQ(refusal_of([&] { static_cast<void>(check_model(capture, true)); }),
              "E-POSES-ROTATION");
}

TEST(ModelCheck, RefusesAPlaneUnlessTheLensIsKnown) {
    SyntheticCaptureOptions scene;
    scene.depth_of_cloud = 0;
    const Capture capture = synthetic_capture(kModelCamera, scene);
    EXPECT_LT(relative_thickness(capture), 1e-6);
    EXPECT_EQ(refusal_of([&] { static_cast<void>(check_model(capture, false)); }),
              "E-POSES-PLANAR");
    EXPECT_THAT(check_model(capture, true), testing::ElementsAre("all points lie in one plane"));
}

TEST(ModelCheck, ThicknessOfABoxIsTheRatioOfItsSides) {
    SyntheticCaptureOptions scene;
    scene.points = 4000;
    scene.depth_of_cloud = 0.2;
    // Leaving out the outer tenth shortens the long sides a little.
    EXPECT_NEAR(relative_thickness(synthetic_capture(kModelCamera, scene)), 0.2, 0.03);
}

TEST(ModelCheck, RefusesFocalLengthsThatNoLensHas) {
    for (const double focal_px : {200.0, 12000.0}) {
        Capture capture = synthetic_capture(kModelCamera, {});
        capture.cameras[0].parameters[0] = focal_px;
        capture.cameras[0].parameters[1] = focal_px;
        EXPECT_EQ(refusal_of([&] { static_cast<void>(check_model(capture, false)); }),
                  "E-POSES-FOCAL")
            << focal_px;
    }
}

TEST(ModelCheck, WarnsWhenOneLensCameOutAsTwo) {
    Capture capture = synthetic_capture(kModelCamera, {});
    capture.cameras.push_back(pinhole_camera(1000, 800, 2000));
    capture.views.back().camera_index = 1;
    EXPECT_THAT(check_model(capture, false),
                testing::ElementsAre(testing::HasSubstr("focal lengths differ")));
}

TEST(ModelCheck, TellsTurningFromWalking) {
    EXPECT_EQ(refusal_of([] { refuse_turning_camera({10, 9, 10, 0.95}); }), "E-POSES-ROTATION");
    EXPECT_EQ(refusal_of([] { refuse_turning_camera({10, 10, 10, 0.8}); }), "none");
    EXPECT_EQ(refusal_of([] { refuse_turning_camera({10, 3, 10, 0.5}); }), "none");
    EXPECT_EQ(refusal_of([] { refuse_turning_camera({}); }), "none");
}

}  // namespace
}  // namespace lumi
