#include "meshing/cameras/camera_mesh_builder.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>

#include "calib/capture/rigid3.h"
#include "calib/work/error.h"
#include "meshing/cameras/scene_centre.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

struct Stand {
    const char* name;
    Points centres;
    MeshConstruction construction;
    int kept;
};

Points shaken(const Points& centres, double amount) {
    std::mt19937 random(9);
    Points result;
    for (const Eigen::Vector3d& centre : centres) {
        result.push_back(centre + amount * random_direction(random));
    }
    return result;
}

Points row_of(int count) {
    Points row;
    for (int i = 0; i < count; ++i) row.emplace_back(0.3 * i - 0.15 * (count - 1), 0, -3);
    return row;
}

/// Cameras around a scene of radius 0.4 at the origin.
std::vector<Stand> stands() {
    using enum MeshConstruction;
    Points sphere = sphere_directions(40, -1);
    Points with_twin = sphere;
    with_twin.push_back(sphere[11]);
    Points with_one_behind = sphere;
    with_one_behind.push_back(1.5 * sphere[11]);
    Points two_rows = row_of(8);
    for (const Eigen::Vector3d& centre : row_of(8)) {
        two_rows.push_back(centre + Eigen::Vector3d(0, 0.3, 0));
    }
    const Points tetrahedron{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    return {
        {"one", {{0, 0, -3}}, kSingle, 1},
        {"several on one spot", {{0, 0, -3}, {0, 0, -3}, {0, 0, -3}}, kSingle, 1},
        {"two", row_of(2), kPair, 2},
        {"two behind each other", {{0, 0, -3}, {0, 0, -4}}, kNearest, 2},
        {"a walk towards the scene", {{0, 0, -3}, {0, 0, -4}, {0, 0, -5}, {0, 0, -6}}, kNearest, 4},
        {"three in a row", row_of(3), kLine, 3},
        {"collinear", row_of(9), kLine, 9},
        {"nearly collinear", shaken(row_of(9), 0.02), kLine, 9},
        {"three in a triangle", {{-1, 0, -3}, {1, 0, -3}, {0, 1.5, -3}}, kOpen, 3},
        {"nearly planar", shaken(two_rows, 0.01), kOpen, 16},
        {"two rows", two_rows, kOpen, 16},
        {"dome", sphere_directions(60, 0), kOpen, 30},
        {"all around", sphere, kClosed, 40},
        {"tetrahedron", tetrahedron, kClosed, 4},
        {"all around with a twin", with_twin, kClosed, 40},
        {"all around with one behind another", with_one_behind, kClosed, 41}};
}

Capture capture_at(const Points& centres) {
    std::mt19937 random(1);
    return capture_of(centres, Eigen::Vector3d::Zero(),
                      points_in_ball(300, Eigen::Vector3d::Zero(), 0.4, random));
}

TEST(CameraMeshBuilder, NamesTheConstructionOfEveryArrangement) {
    for (const Stand& stand : stands()) {
        const Capture capture = capture_at(stand.centres);
        const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
        const CameraMeshEvidence& evidence = built.evidence;
        EXPECT_EQ(built.mesh.construction, stand.construction)
            << stand.name << ": " << evidence.explanation;
        EXPECT_EQ(evidence.cameras_kept, stand.kept) << stand.name;
        EXPECT_EQ(evidence.cameras_total, static_cast<int>(stand.centres.size())) << stand.name;
        EXPECT_EQ(evidence.explanation.find(name_of(stand.construction)), 0U)
            << evidence.explanation;
        EXPECT_NO_THROW(validate(built.mesh, static_cast<int>(capture.views.size()), stand.name));
    }
}

TEST(CameraMeshBuilder, GivesFiniteWeightsThatSumToOneOrNone) {
    for (const Stand& stand : stands()) {
        const Capture capture = capture_at(stand.centres);
        const CameraMesh mesh = build_camera_mesh(capture, all_views(capture), {}).mesh;
        std::mt19937 random(2);
        int answered = 0;
        for (const Eigen::Vector3d& eye :
             points_in_ball(2000, Eigen::Vector3d::Zero(), 4, random)) {
            const auto weights = weights_of_ray(mesh, eye, random_direction(random));
            if (!weights) continue;
            ++answered;
            double sum = 0;
            for (const double weight : weights->weights) {
                EXPECT_TRUE(std::isfinite(weight) && weight >= 0) << stand.name;
                sum += weight;
            }
            EXPECT_NEAR(sum, 1, 1e-12) << stand.name;
        }
        EXPECT_GT(answered, 50) << stand.name;
    }
}

TEST(CameraMeshBuilder, DoesNotDependOnTheUnitOfLength) {
    for (const Stand& stand : stands()) {
        const Capture capture = capture_at(stand.centres);
        const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
        for (const double scale : {1e-6, 1e6}) {
            Capture scaled = capture;
            for (View& view : scaled.views) view.cam_from_world.translation *= scale;
            for (ScenePoint& point : scaled.points) point.position_in_world *= scale;
            const BuiltCameraMesh again = build_camera_mesh(scaled, all_views(scaled), {});
            EXPECT_EQ(again.mesh.construction, built.mesh.construction) << stand.name;
            ASSERT_EQ(again.mesh.vertices.size(), built.mesh.vertices.size()) << stand.name;
            EXPECT_EQ(again.mesh.faces.size(), built.mesh.faces.size()) << stand.name;
            EXPECT_EQ(again.evidence.cameras_kept, built.evidence.cameras_kept);
            EXPECT_NEAR(again.evidence.kernel_radius_over_scene_radius,
                        built.evidence.kernel_radius_over_scene_radius,
                        1e-6 * built.evidence.kernel_radius_over_scene_radius)
                << stand.name;
        }
    }
}

std::set<int> views_of(const CameraMesh& mesh) {
    std::set<int> views;
    for (const CameraMesh::Vertex& vertex : mesh.vertices) views.insert(vertex.view_index);
    return views;
}

TEST(CameraMeshBuilder, KeepsTheSameCamerasHoweverTheWorldIsTurnedAndWhereverItBegins) {
    std::vector<Stand> all = stands();
    Points arc;
    for (const double azimuth : {0.0, 0.2, 0.4, 0.6, 0.8}) {
        for (int twin = 0; twin < 3; ++twin)
            arc.emplace_back(3 * std::cos(azimuth), 3 * std::sin(azimuth), 0.5);
    }
    all.push_back({"an arc of three on each spot", arc, MeshConstruction::kLine, 5});
    for (const Stand& stand : all) {
        Capture capture = capture_at(stand.centres);
        for (View& view : capture.views) {  // Twins are held differently, and round differently.
            const auto index = static_cast<double>(&view - capture.views.data());
            const Eigen::AngleAxisd roll(0.37 * index, Eigen::Vector3d::UnitZ());
            view.cam_from_world.rotation = roll * view.cam_from_world.rotation;
            view.cam_from_world.translation = roll * view.cam_from_world.translation;
        }
        const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
        for (const double turn_rad : {0.3, 1.1, 2.9}) {
            const Eigen::Quaterniond turn(
                Eigen::AngleAxisd(turn_rad, Eigen::Vector3d(1, 2, 3).normalized()));
            const Eigen::Vector3d shift(500, -300, 80);
            Capture moved = capture;
            for (View& view : moved.views) {
                const Eigen::Vector3d centre = turn * centre_in_world(view.cam_from_world) + shift;
                view.cam_from_world.rotation = view.cam_from_world.rotation * turn.inverse();
                view.cam_from_world.translation = -(view.cam_from_world.rotation * centre);
            }
            for (ScenePoint& point : moved.points)
                point.position_in_world = turn * point.position_in_world + shift;
            const BuiltCameraMesh again = build_camera_mesh(moved, all_views(moved), {});
            EXPECT_EQ(again.mesh.construction, built.mesh.construction) << stand.name;
            EXPECT_EQ(views_of(again.mesh), views_of(built.mesh)) << stand.name;
            EXPECT_EQ(again.mesh.faces.size(), built.mesh.faces.size()) << stand.name;
        }
    }
}

TEST(CameraMeshBuilder, TurnsARingThatLooksOutwardsInsideOut) {
    constexpr int kCameras = 12;
    Capture capture;
    capture.cameras.push_back(pinhole_camera(640, 480, 500));
    for (int i = 0; i < kCameras; ++i) {
        const double azimuth = 2 * std::numbers::pi * i / kCameras;
        const Eigen::Vector3d outward(std::cos(azimuth), std::sin(azimuth), 0);
        View view;
        view.name = "view" + std::to_string(i);
        view.cam_from_world.rotation = turn_between(outward, Eigen::Vector3d::UnitZ());
        view.cam_from_world.translation = -(view.cam_from_world.rotation * outward);
        capture.views.push_back(view);
        ScenePoint point;
        point.position_in_world = 10 * outward;
        point.track.push_back({i, Eigen::Vector2d::Zero()});
        capture.points.push_back(point);
    }
    const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
    EXPECT_NE(built.evidence.explanation.find("inside out"), std::string::npos)
        << built.evidence.explanation;
    EXPECT_EQ(built.evidence.cameras_kept, kCameras);
    // From the middle, what a camera looks at is drawn from that camera, not from its opposite.
    for (int i = 0; i < kCameras; ++i) {
        const Eigen::Vector3d eye(0.01, -0.02, 0.03);
        const Eigen::Vector3d camera =
            centre_in_world(capture.views[static_cast<std::size_t>(i)].cam_from_world);
        const auto weights = weights_of_ray(built.mesh, eye, camera - eye);
        ASSERT_TRUE(weights.has_value());
        EXPECT_NEAR(weights_by_view(*weights, kCameras)[static_cast<std::size_t>(i)], 1, 1e-9);
    }
}

TEST(CameraMeshBuilder, UsesOnlyTheListedViews) {
    const Capture capture = capture_at(sphere_directions(40, -1));
    std::vector<int> odd;
    for (int view = 1; view < 40; view += 2) odd.push_back(view);
    const BuiltCameraMesh built = build_camera_mesh(capture, odd, {});
    EXPECT_EQ(built.evidence.cameras_kept, 20);
    for (const CameraMesh::Vertex& vertex : built.mesh.vertices) {
        EXPECT_EQ(vertex.view_index % 2, 1);
    }
}

TEST(CameraMeshBuilder, RefusesNoViewsUnknownNamesAndImpossibleConstructions) {
    const Capture capture = capture_at(row_of(5));
    const auto code_of = [&](const std::vector<int>& views, const std::string& construction) {
        try {
            (void)build_camera_mesh(capture, views, {.construction = construction});
        } catch (const Error& error) {
            return error.code();
        }
        return std::string("built");
    };
    EXPECT_EQ(code_of({}, "auto"), "E-MESH-NOVIEW");
    EXPECT_EQ(code_of(all_views(capture), "round"), "E-CONFIG-VALUE");
    EXPECT_EQ(code_of(all_views(capture), "closed"), "E-MESH-CONSTRUCTION");
    EXPECT_EQ(code_of(all_views(capture), "open"), "E-MESH-CONSTRUCTION");
    EXPECT_EQ(code_of(all_views(capture), "line"), "built");
}

TEST(CameraMeshOptions, AreReadFromTheirSection) {
    const auto section = ConfigSection::from_text("construction = \"open\"\n", "test");
    EXPECT_EQ(read_camera_mesh_options(section).construction, "open");
    const auto wrong = ConfigSection::from_text("construction = \"round\"\n", "test");
    EXPECT_THROW((void)read_camera_mesh_options(wrong), Error);
}

TEST(SceneCentre, IsWhereConvergingAxesMeet) {
    const Eigen::Vector3d target(3, -1, 2);
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(20, 0)) {
        centres.push_back(target + 5 * direction);
    }
    // One camera looks elsewhere, and no depth is known.
    Capture capture = capture_of(centres, target, {});
    capture.views[4].cam_from_world =
        capture_of({centres[4]}, {40, 40, 0}, {}).views[0].cam_from_world;
    const auto centre = estimate_scene_centre(optical_axes(capture, all_views(capture)));
    EXPECT_LT((centre - target).norm(), 0.2);
}

TEST(SceneCentre, IsImprovedWithinReachOnly) {
    const Eigen::Vector3d start(1, 2, 3);
    const Eigen::Vector3d near_by = start + Eigen::Vector3d(0.3, -0.2, 0.1);
    const Eigen::Vector3d far_off = start + Eigen::Vector3d(40, 0, 0);
    const auto towards = [](const Eigen::Vector3d& goal) {
        return [goal](const Eigen::Vector3d& centre) { return -(centre - goal).norm(); };
    };
    EXPECT_LT((improve_scene_centre(start, 1, 0, 120, towards(near_by)) - near_by).norm(),
              1.0 / 16);
    const Eigen::Vector3d stopped = improve_scene_centre(start, 1, 0, 120, towards(far_off));
    EXPECT_LT((stopped - (start + Eigen::Vector3d::UnitX())).norm(), 1.0 / 16);
    const auto flat = [](const Eigen::Vector3d&) { return 1.0; };
    EXPECT_EQ(improve_scene_centre(start, 1, 0, 120, flat), start);
}

TEST(SceneCentre, OfParallelAxesIsAtTheSeenDepth) {
    std::mt19937 random(1);
    const Capture capture =
        capture_of(row_of(6), {0, 0, 1e7}, points_in_ball(500, {0, 0, 7}, 0.5, random));
    const auto centre = estimate_scene_centre(optical_axes(capture, all_views(capture)));
    EXPECT_NEAR(centre.z(), 7, 0.2);
    EXPECT_NEAR(centre.x(), 0, 0.1);
}

}  // namespace
}  // namespace lumi
