// What the refinement makes of photographs whose lens was moved from one to the next.
#include "calib/poses/refinement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "calib/poses/pose_shift.h"
#include "calib/poses/residual_pattern.h"
#include "tests/calib/adjust/synthetic_capture.h"

namespace lumi {
namespace {

constexpr double kNoise_px = 0.3;

Camera lens_with_middle(double x_px, double y_px) {
    return {1000, 800, LensModel::kSimpleRadial, {850, x_px, y_px, -0.05}};
}

Capture exact_scene(const Camera& lens, unsigned seed, int points = 150) {
    SyntheticCaptureOptions scene;
    scene.points = points;
    scene.arc_radius = 2.2;
    scene.seed = seed;
    return synthetic_capture(lens, scene);
}

/// A path on one level with upright pictures: there a principal point that is too low, and cameras
/// that look up by as much, show almost the same.
Capture exact_level_scene(const Camera& lens, unsigned seed) {
    SyntheticCaptureOptions scene;
    scene.views = 9;
    scene.points = 150;
    scene.arc_radius = 2.2;
    scene.seed = seed;
    Capture capture = synthetic_capture(lens, scene);
    for (View& view : capture.views) {
        Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
        centre.y() = 0;
        const Eigen::Vector3d forward = -centre.normalized();
        Eigen::Matrix3d world_from_cam;
        world_from_cam << Eigen::Vector3d::UnitY().cross(forward), Eigen::Vector3d::UnitY(),
            forward;
        const Eigen::Quaterniond cam_from_world(Eigen::Matrix3d(world_from_cam.transpose()));
        view.cam_from_world = {cam_from_world, -(cam_from_world * centre)};
    }
    for (ScenePoint& point : capture.points) {
        point.track.clear();
        for (int view = 0; view < scene.views; ++view) {
            const Rigid3& pose = capture.views[static_cast<std::size_t>(view)].cam_from_world;
            const auto pixel = project(lens, pose * point.position_in_world);
            if (pixel && is_inside(lens, *pixel)) point.track.push_back({view, *pixel});
        }
    }
    std::erase_if(capture.points, [](const ScenePoint& point) { return point.track.size() < 2; });
    return capture;
}

/// With noise, and with the middle of each picture elsewhere, as a stabiliser in the lens does it:
/// `shift_px` is the standard deviation of a coordinate.
Capture as_photographed(Capture capture, double shift_px, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> gaussian(0.0, 1.0);
    std::vector<Eigen::Vector2d> shifts;
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        const double x_px = shift_px * gaussian(random);
        shifts.emplace_back(x_px, shift_px * gaussian(random));
    }
    for (ScenePoint& point : capture.points) {
        for (Observation& seen : point.track) {
            const double x_px = kNoise_px * gaussian(random);
            seen.pixel += Eigen::Vector2d(x_px, kNoise_px * gaussian(random)) +
                          shifts[static_cast<std::size_t>(seen.view_index)];
        }
    }
    return capture;
}

struct Refined {
    Capture capture;
    PoseEvidence evidence;
};

/// From where mapping leaves it: the usual model, a focal length that is a bit off.
Refined refined(Capture capture, LensPolicy policy = LensPolicy::kAuto) {
    capture.cameras[0] = {1000, 800, LensModel::kSimpleRadial, {860, 500, 400, 0}};
    Refined result{std::move(capture), {}};
    SilentProgress progress;
    refine(result.capture, policy, {}, 2, result.evidence, progress);
    return result;
}

TEST(Refinement, FindsAPrincipalPointThatIsTheSameInAllPictures) {
    const Refined found =
        refined(as_photographed(exact_scene(lens_with_middle(525, 380), 1), 0, 1));
    EXPECT_FALSE(holds_principal_point(found.evidence.lenses[0].form));
    const Eigen::Vector2d middle_px = principal_point_px(found.capture.cameras[0]);
    EXPECT_NEAR(middle_px.x(), 525, 5);
    EXPECT_NEAR(middle_px.y(), 380, 5);
}

TEST(Refinement, BelievesInNoCommonPrincipalPointWhereEachPictureHasItsOwn) {
    constexpr unsigned kSeed = 6;  // Others mostly leave it in the middle anyway.
    const Capture truth = exact_level_scene(lens_with_middle(500, 400), kSeed);
    const Refined found = refined(as_photographed(truth, 12, kSeed));
    EXPECT_TRUE(holds_principal_point(found.evidence.lenses[0].form))
        << principal_point_px(found.capture.cameras[0]).transpose();
    const double error_deg =
        compare_poses(named_poses(found.capture), named_poses(truth)).max_rotation_deg;
    EXPECT_LT(error_deg, 3.0) << "12 px are 0.8 degrees";
}

/// A middle off by so little, among so much noise, that held-out views are predicted as well
/// without it.
TEST(Refinement, FindsAPrincipalPointThatLooksLikeAZoomThoughHeldOutViewsDoNotAskForIt) {
    SyntheticCaptureOptions scene;
    scene.points = 3000;
    scene.noise_px = 0.5;
    scene.arc_deg = 40;
    const Eigen::Vector2d true_px(490, 388);
    const Refined found = refined(synthetic_capture(
        {1000, 800, LensModel::kSimplePinhole, {850, true_px.x(), true_px.y()}}, scene));
    const LensEvidence& evidence = found.evidence.lenses[0];
    EXPECT_FALSE(holds_principal_point(evidence.form));
    EXPECT_TRUE(evidence.choice->choice().form == evidence.form);
    EXPECT_FALSE(residual_pattern(found.capture).is_zoomed());
    EXPECT_LT((principal_point_px(found.capture.cameras[0]) - true_px).norm(), 6)
        << "16 px from the middle";
}

/// Root mean square over the views, as a share of the cameras' spread.
double stated_share(const Refined& found) {
    double square = 0;
    for (const ViewUncertainty& view : found.evidence.views) {
        square += view.position_sigma * view.position_sigma;
    }
    return std::sqrt(square / static_cast<double>(found.evidence.views.size())) /
           spread_of_centres(named_poses(found.capture));
}

TEST(Refinement, FourTimesThePointsMakePlacesSurerOnlyWhereErrorsAreIndependent) {
    for (const double shift_px : {0.0, 12.0}) {
        const auto stated = [&](int points) {
            return stated_share(refined(
                as_photographed(exact_scene(lens_with_middle(500, 400), 1, points), shift_px, 1),
                LensPolicy::kNamed));
        };
        const double gain = stated(150) / stated(600);
        if (shift_px > 0) {
            EXPECT_LT(gain, 1.3);
        } else {
            EXPECT_NEAR(gain, 2.0, 0.4);
        }
    }
}

TEST(Refinement, TellsOfNoLensWhosePhotographsWereAllDropped) {
    Capture capture = as_photographed(exact_scene(lens_with_middle(500, 400), 2), 0, 2);
    // A lens of its own, of a focal length that no lens has, with a view that sees next to nothing.
    capture.cameras.insert(capture.cameras.begin(),
                           {1000, 800, LensModel::kSimpleRadial, {20000, 500, 400, 0}});
    for (View& view : capture.views) view.camera_index = 1;
    capture.views[3].camera_index = 0;
    const std::string dropped = capture.views[3].name;
    int seen_points = 0;
    for (ScenePoint& point : capture.points) {
        std::erase_if(point.track, [&](const Observation& seen) {
            return seen.view_index == 3 && ++seen_points > 5;
        });
    }
    const std::size_t views = capture.views.size();
    PoseEvidence evidence;
    SilentProgress progress;
    refine(capture, LensPolicy::kNamed, {}, 1, evidence, progress);
    ASSERT_EQ(capture.views.size(), views - 1);
    ASSERT_EQ(capture.cameras.size(), 1u);
    EXPECT_NEAR(focal_length_px(capture.cameras[0]).mean(), 850, 20);
    for (const View& view : capture.views) {
        EXPECT_NE(view.name, dropped);
        EXPECT_EQ(view.camera_index, 0) << view.name;
    }
    ASSERT_EQ(evidence.lenses.size(), 1u);
    EXPECT_EQ(evidence.lenses[0].views, static_cast<int>(views) - 1);
}

}  // namespace
}  // namespace lumi
