// The plane that stands for the scene, as an eye walks up to its centre and past it.
#include "render/transfer/scene_plane.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

class ScenePlaneOfAnApproachingEye : public testing::Test {
 protected:
    /// The inverse depth in the middle of the picture of an eye that looks along z, so far before
    /// the scene's centre (in the scene's near depths; negative: behind it).
    [[nodiscard]] double inverse_depth(double before) const {
        const Eigen::Vector3d centre = lumigraph_.mesh.scene_centre_in_world;
        const Eigen::Vector3d position =
            centre - before * lumigraph_.near_depth * Eigen::Vector3d::UnitZ();
        const Eye eye =
            eye_at(position, position + Eigen::Vector3d::UnitZ(), pinhole_camera(160, 120, 140));
        return scene_plane_inverse_depth(lumigraph_, eye).dot(Eigen::Vector3d(80, 60, 1));
    }

    const Lumigraph lumigraph_ = card_before_wall();
};

TEST_F(ScenePlaneOfAnApproachingEye, PassesThroughTheCentreOfAnEyeBeyondTheNearDepth) {
    for (const double before : {1.0, 1.5, 4.0}) {
        EXPECT_NEAR(inverse_depth(before), 1 / (before * lumigraph_.near_depth), 1e-12);
    }
}

TEST_F(ScenePlaneOfAnApproachingEye, StaysAtTheNearDepthOfACloserEye) {
    for (const double before : {0.9, 0.5, 0.2}) {
        EXPECT_NEAR(inverse_depth(before), 1 / lumigraph_.near_depth, 1e-12) << before;
    }
}

TEST_F(ScenePlaneOfAnApproachingEye, DoesNotJumpWhereTheEyePassesTheCentre) {
    for (double before = 0.3; before > -0.3; before -= 1e-4) {
        EXPECT_LT(std::abs(inverse_depth(before) - inverse_depth(before - 1e-4)),
                  1e-3 / lumigraph_.near_depth)
            << before;
    }
    EXPECT_NEAR(inverse_depth(0), 0, 1e-12);
}

}  // namespace
}  // namespace lumi
