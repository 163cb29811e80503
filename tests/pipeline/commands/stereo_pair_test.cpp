#include "pipeline/commands/stereo_pair.h"

#include <gtest/gtest.h>

#include <vector>

namespace lumi {
namespace {

/// A scene about a centre, and an eye that looks past it, its picture's middle off its axis.
class StereoPair : public testing::Test {
 protected:
    StereoPair() {
        lumigraph_.mesh.scene_centre_in_world = {0.4, -0.3, 5};
        lumigraph_.near_depth = 2;
        const Eigen::AngleAxisd turn(0.2, Eigen::Vector3d(1, 2, 3).normalized());
        eye_ = {{64, 48, LensModel::kPinhole, {70, 75, 35, 21}},
                {Eigen::Quaterniond(turn), Eigen::Vector3d(0.1, -0.2, 0.3)}};
    }

    /// The eyes that the pair of this baseline is drawn for.
    [[nodiscard]] std::vector<Eye> eyes_of_pair(double baseline) const {
        std::vector<Eye> eyes;
        const ColorImage picture = picture_of(lumigraph_, eye_, baseline, [&](const Eye& eye) {
            eyes.push_back(eye);
            return empty_frame(eye.camera);
        });
        EXPECT_EQ(picture.width(), static_cast<int>(eyes.size()) * eye_.camera.width_px);
        return eyes;
    }

    /// What the eye sees in the middle of its picture, so many times as far away as the plane
    /// through the scene's centre that faces the eye.
    [[nodiscard]] Eigen::Vector3d middle_in_world(double distances) const {
        const std::vector<double>& k = eye_.camera.parameters;
        const Eigen::Vector3d ray((32 - k[2]) / k[0], (24 - k[3]) / k[1], 1);
        const Eigen::Vector3d centre = eye_.cam_from_world * lumigraph_.mesh.scene_centre_in_world;
        const double depth = centre.squaredNorm() / centre.dot(ray);
        return inverse(eye_.cam_from_world) * (distances * depth * ray);
    }

    static Eigen::Vector2d seen_px(const Eye& eye, const Eigen::Vector3d& in_world) {
        const Eigen::Vector3d in_eye = eye.cam_from_world * in_world;
        const std::vector<double>& k = eye.camera.parameters;
        return {k[0] * in_eye.x() / in_eye.z() + k[2], k[1] * in_eye.y() / in_eye.z() + k[3]};
    }

    Lumigraph lumigraph_;
    Eye eye_;
};

TEST_F(StereoPair, TheScenesPlaneInTheMiddleOfThePictureIsThereInBoth) {
    const std::vector<Eye> eyes = eyes_of_pair(0.3);
    ASSERT_EQ(eyes.size(), 2U);
    for (const Eye& eye : eyes)
        EXPECT_LT((seen_px(eye, middle_in_world(1)) - Eigen::Vector2d(32, 24)).norm(), 1e-9);
    const auto parallax_px = [&](double distances) {
        const Eigen::Vector3d point = middle_in_world(distances);
        return seen_px(eyes[0], point).x() - seen_px(eyes[1], point).x();
    };
    EXPECT_GT(parallax_px(0.8), 0.1) << "what is nearer comes out of the screen";
    EXPECT_LT(parallax_px(1.2), -0.1) << "what is further lies behind it";
}

TEST_F(StereoPair, TheLeftEyeComesFirstAndTheyLookTheSameWay) {
    const std::vector<Eye> eyes = eyes_of_pair(0.3);
    ASSERT_EQ(eyes.size(), 2U);
    const Eigen::Vector3d apart =
        centre_in_world(eyes[1].cam_from_world) - centre_in_world(eyes[0].cam_from_world);
    EXPECT_LT((eye_.cam_from_world.rotation * apart - Eigen::Vector3d(0.3, 0, 0)).norm(), 1e-12);
    for (const Eye& eye : eyes)
        EXPECT_EQ(eye.cam_from_world.rotation.coeffs(), eye_.cam_from_world.rotation.coeffs());
}

TEST_F(StereoPair, AxesStayParallelWhereTheSceneLiesBehindTheEye) {
    lumigraph_.mesh.scene_centre_in_world *= -1;
    for (const Eye& eye : eyes_of_pair(0.3))
        EXPECT_EQ(eye.camera.parameters, eye_.camera.parameters);
}

TEST_F(StereoPair, WithoutABaselineItIsTheEyesOwnPicture) {
    const std::vector<Eye> eyes = eyes_of_pair(0);
    ASSERT_EQ(eyes.size(), 1U);
    EXPECT_EQ(eyes[0].camera.parameters, eye_.camera.parameters);
}

}  // namespace
}  // namespace lumi
