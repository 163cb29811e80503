#include "meshing/cameras/close_ups.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "calib/capture/rigid3.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

/// Far views all around a ball of radius 1, two close-ups of its +x side and one of its -y side.
struct Scene {
    Points far;
    Points near{{1.5, 0.1, 0}, {1.5, -0.1, 0.05}, {0, -1.5, 0}};
    Capture capture;
};

Scene far_and_near(bool with_close_ups = true) {
    Scene scene;
    for (const Eigen::Vector3d& direction : sphere_directions(40, -1)) {
        scene.far.push_back(4 * direction);
    }
    Points centres = scene.far;
    if (with_close_ups) centres.insert(centres.end(), scene.near.begin(), scene.near.end());
    Points surface;
    for (const Eigen::Vector3d& direction : sphere_directions(600, -1)) {
        surface.push_back(direction);
    }
    scene.capture = capture_of(centres, Eigen::Vector3d::Zero(), surface);
    // A view sees the side of the ball that it is on.
    for (ScenePoint& point : scene.capture.points) {
        std::erase_if(point.track, [&](const Observation& seen) {
            const Eigen::Vector3d& centre = centres[static_cast<std::size_t>(seen.view_index)];
            return (centre - point.position_in_world).dot(point.position_in_world) < 0;
        });
    }
    return scene;
}

BuiltCameraMesh mesh_of(const Scene& scene, const CameraMeshOptions& options = {}) {
    return build_camera_mesh(scene.capture, all_views(scene.capture), options);
}

/// What the shell adds at a ray: weights times fade, one a view.
std::vector<double> shell_share(const CameraMesh& shell, const Eigen::Vector3d& eye,
                                const Eigen::Vector3d& target, std::size_t views) {
    const auto ray = weights_of_ray(shell, eye, target - eye);
    if (!ray) return std::vector<double>(views, 0.0);
    std::vector<double> weights = weights_by_view(*ray, views);
    for (double& weight : weights) weight *= capture_fade(*ray, kShellFadedShare);
    return weights;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum;
}

TEST(CloseUps, HaveShellsOfTheirOwnOneForEachPlaceTheyLookAt) {
    const Scene scene = far_and_near();
    const BuiltCameraMesh built = mesh_of(scene);
    ASSERT_EQ(built.mesh.shells.size(), 2U) << built.evidence.explanation;
    EXPECT_EQ(built.evidence.close_ups, 3);
    EXPECT_EQ(built.evidence.cameras_kept, 43) << built.evidence.explanation;
    EXPECT_NE(built.evidence.explanation.find("3 close-ups refine what they see, in 2 shells"),
              std::string::npos);
    // The far views' mesh is what it would be without them.
    EXPECT_EQ(built.mesh.faces, mesh_of(far_and_near(false)).mesh.faces);
}

TEST(CloseUps, AreVerticesLikeOthersWhereShellsAreNotWanted) {
    const BuiltCameraMesh built = mesh_of(far_and_near(), {.shells = false});
    EXPECT_TRUE(built.mesh.shells.empty());
    EXPECT_EQ(built.evidence.close_ups, 0);
}

TEST(CloseUps, AreNotFoundWhereDistancesVaryAsTheyDoInAHand) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> distance(0.75, 1.25);
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(60, -1)) {
        centres.push_back(3 * distance(random) * direction);
    }
    const Capture capture = capture_of(centres, Eigen::Vector3d::Zero(),
                                       points_in_ball(500, Eigen::Vector3d::Zero(), 1, random));
    EXPECT_TRUE(build_camera_mesh(capture, all_views(capture), {}).mesh.shells.empty());
}

/// Twice as near, but it sees the whole ball: nothing that a shell would have to fade.
TEST(CloseUps, AreNotThoseThatSeeTheWholeScene) {
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(40, -1)) {
        centres.push_back(4 * direction);
    }
    centres.emplace_back(1.5, 0, 0);
    std::mt19937 random(4);
    const Capture capture = capture_of(centres, Eigen::Vector3d::Zero(),
                                       points_in_ball(500, Eigen::Vector3d::Zero(), 0.4, random));
    EXPECT_TRUE(build_camera_mesh(capture, all_views(capture), {}).mesh.shells.empty());
}

/// From the middle of a long room: the near walls are no close-ups.
TEST(CloseUps, AreNotFoundFromTheMiddleOfARoom) {
    Points walls;
    for (const Eigen::Vector3d& direction : sphere_directions(600, -1)) {
        walls.emplace_back(8 * direction.x(), 2 * direction.y(), 2 * direction.z());
    }
    Capture capture = capture_of(sphere_directions(40, -1), Eigen::Vector3d::Zero(), walls);
    for (View& view : capture.views) {
        const Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
        view.cam_from_world.rotation = turn_between(centre, Eigen::Vector3d::UnitZ());
        view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
    }
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    EXPECT_TRUE(built.mesh.shells.empty());
    EXPECT_EQ(built.evidence.cameras_kept, 40);
}

TEST(CloseUps, CountFullyOnTheirOwnRaysAndTheSameFromEveryEyeOnARay) {
    const Scene scene = far_and_near();
    const BuiltCameraMesh built = mesh_of(scene);
    const std::size_t views = scene.capture.views.size();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> along(0.1, 6);
    int refined = 0;
    for (const CameraMesh& shell : built.mesh.shells) {
        for (const CameraMesh::Vertex& vertex : shell.vertices) {
            if (vertex.is_virtual) continue;
            const auto view = static_cast<std::size_t>(vertex.view_index);
            for (int i = 0; i < 40; ++i) {
                const Eigen::Vector3d target =
                    shell.scene_centre_in_world + 0.25 * random_direction(random);
                const auto own = shell_share(shell, vertex.position_in_world, target, views);
                EXPECT_NEAR(own[view], 1, 1e-9);
                const Eigen::Vector3d away = (vertex.position_in_world - target).normalized() +
                                             0.4 * random_direction(random);
                const auto one = shell_share(shell, target + along(random) * away, target, views);
                const auto other = shell_share(shell, target + along(random) * away, target, views);
                EXPECT_LT(distance(one, other), 1e-9);
                refined += distance(one, std::vector<double>(views, 0.0)) > 0 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(refined, 60);
}

/// The eye goes all around the close-ups' place: in, through and out of the shell. Where its
/// weights change most between two steps, the place is narrowed down to rounding: nothing jumps,
/// not at the border either.
TEST(CloseUps, FadeInAndOutWithoutASeam) {
    const Scene scene = far_and_near();
    const BuiltCameraMesh built = mesh_of(scene);
    const std::size_t views = scene.capture.views.size();
    for (const CameraMesh& shell : built.mesh.shells) {
        const Eigen::Vector3d target = shell.scene_centre_in_world;
        const Eigen::Vector3d out = target.normalized();
        const Eigen::Vector3d aside = out.unitOrthogonal();
        for (const double turn : {0.0, 0.7, 1.9}) {
            const Eigen::Vector3d across = Eigen::AngleAxisd(turn, out) * aside;
            const auto at = [&](double angle) {
                const Eigen::Vector3d eye =
                    target + 2.5 * (std::cos(angle) * out + std::sin(angle) * across);
                return shell_share(shell, eye, target, views);
            };
            double most = 0;
            for (int step = -700; step < 700; ++step) {
                double low = 0.002 * step;
                double high = 0.002 * (step + 1);
                if (distance(at(low), at(high)) < 1e-3) continue;
                for (int i = 0; i < 50; ++i) {
                    const double middle = 0.5 * (low + high);
                    (distance(at(low), at(middle)) > distance(at(middle), at(high)) ? high : low) =
                        middle;
                }
                EXPECT_LT(distance(at(low), at(high)), 1e-6) << "at " << low;
            }
            for (const double weight : at(0)) most = std::max(most, weight);
            EXPECT_GT(most, 0.3);
            EXPECT_NEAR(distance(at(1.4), std::vector<double>(views, 0.0)), 0, 1e-12);
        }
    }
}

}  // namespace
}  // namespace lumi
