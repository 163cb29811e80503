#include <gtest/gtest.h>

#include <CGAL/MP_Float.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/cameras/construction.h"
#include "meshing/cameras/edge_flips.h"
#include "meshing/cameras/kernel.h"
#include "meshing/cameras/repair.h"
#include "meshing/cameras/scene_hull.h"
#include "meshing/cameras/slide.h"
#include "meshing/cameras/spherical_triangulation.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

CameraMesh closed_mesh(const Points& centres) {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kClosed;
    Points directions;
    for (const Eigen::Vector3d& centre : centres) {
        mesh.vertices.push_back({centre, static_cast<int>(mesh.vertices.size())});
        directions.push_back(centre.normalized());
    }
    mesh.faces = spherical_triangulation(directions);
    return mesh;
}

Points rough_sphere(int count, double roughness, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> distance(1 - roughness, 1 + roughness);
    Points centres;
    for (const Eigen::Vector3d& direction : sphere_directions(count, -1)) {
        centres.push_back(distance(random) * direction);
    }
    return centres;
}

/// A scene whose hull nearly is a ball.
Points ball_hull(double radius) {
    Points corners;
    for (const Eigen::Vector3d& direction : sphere_directions(60, -1)) {
        corners.push_back(radius * direction);
    }
    return corners;
}

TEST(SceneHull, HoldsThePointsItKeeps) {
    std::mt19937 random(1);
    Points points = points_in_ball(1000, {3, -1, 2}, 0.5, random);
    points.emplace_back(100, 0, 0);
    const Points hull = scene_hull(points, 0.95);
    EXPECT_LT(hull.size(), 300U);
    for (const Eigen::Vector3d& corner : hull) EXPECT_LT((corner - points[0]).norm(), 1.1);
    // A half-space that holds the hull holds all but a twentieth of the points.
    for (int i = 0; i < 100; ++i) {
        const Eigen::Vector3d normal = random_direction(random);
        double reach = -1e9;
        for (const Eigen::Vector3d& corner : hull) reach = std::max(reach, normal.dot(corner));
        const auto beyond = std::count_if(points.begin(), points.end(), [&](const auto& point) {
            return normal.dot(point) > reach + 1e-12;
        });
        EXPECT_LE(beyond, 51);
    }
}

TEST(SceneHull, OfPointsInOnePlaneAreThePointsThemselves) {
    EXPECT_TRUE(scene_hull({}, 1.0).empty());
    EXPECT_EQ(scene_hull({{1, 2, 3}}, 1.0).size(), 1U);
    EXPECT_EQ(scene_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}}, 1.0).size(),
              5U);
}

/// Two cameras stand far in on a long valley; the diagonal along it keeps the scene, the other one
/// does not.
TEST(EdgeFlips, BringASceneIntoTheKernelThatOnlyTheWrongDiagonalKeepsOut) {
    int repaired = 0;
    for (unsigned seed = 1; seed <= 30; ++seed) {
        CameraMesh mesh = closed_mesh(rough_sphere(40, 0.25, seed));
        const Points scene = ball_hull(0.6);
        const double before = scene_clearance(mesh, scene);
        CameraMesh flipped = mesh;
        const int flips = flip_edges_for_room(flipped, scene, 0.0);
        const double after = scene_clearance(flipped, scene);
        EXPECT_GE(after, before) << "seed " << seed;
        EXPECT_TRUE(before < 0 || flips == 0);
        if (before < 0 && after >= 0) ++repaired;
        // Still a closed surface that is star-shaped about the centre, with the same cameras.
        EXPECT_EQ(flipped.faces.size(), mesh.faces.size());
        EXPECT_EQ(distinct_views(flipped), 40);
        EXPECT_GT(kernel_radius(face_planes(flipped)), 0);
        std::mt19937 random(seed);
        for (int i = 0; i < 300; ++i) {
            EXPECT_EQ(entering_faces(flipped, Eigen::Vector3d::Zero(), random_direction(random)),
                      1);
        }
    }
    EXPECT_GT(repaired, 0);
}

TEST(Slide, LeavesAMeshAloneWhoseKernelHoldsTheScene) {
    CameraMesh mesh = closed_mesh(rough_sphere(60, 0.05, 3));
    const CameraMesh before = mesh;
    const SlideReport report = slide_into_kernel(mesh, ball_hull(0.3));
    EXPECT_TRUE(report.reached);
    EXPECT_EQ(report.cameras_slid, 0);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        EXPECT_EQ(mesh.vertices[i].position_in_world, before.vertices[i].position_in_world);
    }
}

TEST(Slide, BringsTheSceneIntoTheKernelAlongTheCamerasOwnDirections) {
    int needed = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const CameraMesh before = closed_mesh(rough_sphere(80, 0.25, seed));
        const Points scene = ball_hull(0.65);
        if (scene_clearance(before, scene) >= 0) continue;
        ++needed;
        CameraMesh mesh = before;
        const SlideReport report = slide_into_kernel(mesh, scene);
        ASSERT_TRUE(report.reached) << "seed " << seed;
        EXPECT_GE(scene_clearance(mesh, scene), 0) << "seed " << seed;
        EXPECT_GT(report.cameras_slid, 0);
        EXPECT_LE(report.largest_share, SlideOptions{}.longest_slide + 1e-6);
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            const Eigen::Vector3d& from = before.vertices[i].position_in_world;
            const Eigen::Vector3d& to = mesh.vertices[i].position_in_world;
            EXPECT_LT(from.normalized().cross(to.normalized()).norm(), 1e-12);
        }
        std::mt19937 random(seed);
        for (const Eigen::Vector3d& point :
             points_in_ball(500, Eigen::Vector3d::Zero(), 0.6, random)) {
            EXPECT_EQ(entering_faces(mesh, point, random_direction(random)), 1);
        }
    }
    EXPECT_GT(needed, 5);
}

TEST(Slide, LeavesTheMeshAsItWasWhenNoShortSlideHelps) {
    CameraMesh mesh = closed_mesh(rough_sphere(20, 0.0, 1));
    const CameraMesh before = mesh;
    const SlideReport report = slide_into_kernel(mesh, ball_hull(1.5));
    EXPECT_FALSE(report.reached);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        EXPECT_EQ(mesh.vertices[i].position_in_world, before.vertices[i].position_in_world);
    }
}

/// The same quadratic programme, every constraint at once, by CGAL's exact solver.
std::vector<double> inverse_distances_by_cgal(const CameraMesh& mesh, const Points& scene,
                                              const SlideOptions& options) {
    CGAL::Quadratic_program<double> programme(CGAL::SMALLER, false, 0, false, 0);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const double distance = mesh.vertices[i].position_in_world.norm();
        const double weight = std::pow(distance, 4);
        const auto variable = static_cast<int>(i);
        programme.set_d(variable, variable, 2 * weight);
        programme.set_c(variable, -2 * weight / distance);
        programme.set_l(variable, true, 1 / (distance * (1 + options.longest_slide)));
        programme.set_u(variable, true, 1 / (distance * (1 - options.longest_slide)));
    }
    int row = 0;
    for (const CameraMesh::Face& face : mesh.faces) {
        Eigen::Matrix3d directions;
        for (Eigen::Index i = 0; i < 3; ++i) {
            const auto vertex = static_cast<std::size_t>(face[static_cast<std::size_t>(i)]);
            directions.col(i) = mesh.vertices[vertex].position_in_world.normalized();
        }
        for (const Eigen::Vector3d& corner : scene) {
            const Eigen::Vector3d coefficients = directions.inverse() * corner;
            for (Eigen::Index i = 0; i < 3; ++i) {
                programme.set_a(face[static_cast<std::size_t>(i)], row, coefficients[i]);
            }
            programme.set_b(row++, 1 / (1 + options.room));
        }
    }
    const auto solution = CGAL::solve_quadratic_program(programme, CGAL::MP_Float());
    std::vector<double> result;
    if (!solution.is_optimal()) return result;
    for (auto value = solution.variable_values_begin(); value != solution.variable_values_end();
         ++value) {
        result.push_back(CGAL::to_double(*value));
    }
    return result;
}

TEST(Slide, IsTheOptimumThatAnExactSolverFinds) {
    int compared = 0;
    for (unsigned seed = 1; seed <= 40 && compared < 4; ++seed) {
        // Unit mean distance, as the programme is scaled within.
        CameraMesh mesh = closed_mesh(rough_sphere(14, 0.25, seed));
        double mean = 0;
        for (const auto& vertex : mesh.vertices) mean += vertex.position_in_world.norm() / 14;
        for (auto& vertex : mesh.vertices) vertex.position_in_world /= mean;
        const Points scene{{0.65, 0, 0},  {-0.65, 0, 0}, {0, 0.65, 0},
                           {0, -0.65, 0}, {0, 0, 0.65},  {0, 0, -0.65}};
        if (scene_clearance(mesh, scene) >= 0) continue;
        const std::vector<double> expected = inverse_distances_by_cgal(mesh, scene, {});
        CameraMesh slid = mesh;
        const SlideReport report = slide_into_kernel(slid, scene);
        ASSERT_EQ(report.reached, !expected.empty()) << "seed " << seed;
        if (expected.empty()) continue;
        ++compared;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_NEAR(1 / slid.vertices[i].position_in_world.norm(), expected[i], 2e-6)
                << "seed " << seed;
        }
    }
    EXPECT_GE(compared, 2);
}

/// Rays to a ball of radius r about the centre, through a camera whose weights were slid by s:
///     1 - w <= s r / (rho h nu)
/// with rho its distance, h the smallest altitude of its faces and nu the least cosine between such
/// a ray and a face's normal. (For faces perpendicular to the camera's direction nu = cos alpha,
/// sin alpha = r / rho; steeper faces lose more.)
TEST(Slide, CostsACameraNoMoreOfItsOwnRaysThanTheStatedBound) {
    int slid_cameras = 0;
    int beyond_flat_formula = 0;
    constexpr double kRadius = 0.65;
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const Points centres = rough_sphere(80, 0.25, seed);
        CameraMesh mesh = closed_mesh(centres);
        const Points scene = ball_hull(kRadius);
        if (!slide_into_kernel(mesh, scene).reached) continue;
        for (std::size_t camera = 0; camera < centres.size(); ++camera) {
            const double slide =
                std::abs(mesh.vertices[camera].position_in_world.norm() - centres[camera].norm());
            double altitude = 1e9;
            double cosine = 1;
            for (const CameraMesh::Face& face : mesh.faces) {
                const auto place = std::find(face.begin(), face.end(), static_cast<int>(camera));
                if (place == face.end()) continue;
                const auto at = static_cast<std::size_t>(place - face.begin());
                const auto corner = [&](std::size_t i) {
                    return mesh.vertices[static_cast<std::size_t>(face[(at + i) % 3])]
                        .position_in_world;
                };
                const Eigen::Vector3d side = (corner(2) - corner(1)).normalized();
                altitude = std::min(altitude, side.cross(corner(0) - corner(1)).norm());
                const Eigen::Vector3d normal = face_plane(mesh, face).outward_normal;
                for (const Eigen::Vector3d& point : scene) {
                    cosine = std::min(cosine, normal.dot((centres[camera] - point).normalized()));
                }
            }
            double loss = 0;
            for (const Eigen::Vector3d& point : scene) {
                const auto weights = weights_of_ray(mesh, centres[camera], point - centres[camera]);
                ASSERT_TRUE(weights.has_value());
                loss = std::max(loss, 1 - weights_by_view(*weights, centres.size())[camera]);
            }
            if (slide < 1e-9) {
                EXPECT_LT(loss, 1e-9);
                continue;
            }
            ++slid_cameras;
            const double sine = kRadius / centres[camera].norm();
            const double flat = slide * sine / std::sqrt(1 - sine * sine) / altitude;
            if (loss > flat + 1e-9) ++beyond_flat_formula;
            const double radial = slide * kRadius / centres[camera].norm() / altitude;
            const double bound = cosine > 0 ? std::min(1.0, radial / cosine) : 1.0;
            EXPECT_LE(loss, bound + 1e-9) << "seed " << seed << " camera " << camera;
        }
        const EpipoleLoss loss = epipole_loss(
            mesh, [&](int view) { return centres[static_cast<std::size_t>(view)]; }, scene);
        EXPECT_GT(loss.worst, 0);
        EXPECT_LE(loss.worst, loss.worst_bound + 1e-9);
        EXPECT_LE(loss.worst_bound, 1);
        EXPECT_LE(loss.worst_over_bound, 1 + 1e-9);
        EXPECT_LT(loss.rms, loss.worst);
    }
    EXPECT_GT(slid_cameras, 50);
    // With nu = cos alpha it would be no bound.
    EXPECT_GT(beyond_flat_formula, 0);
}

TEST(Repair, OfAStripSlidesWithinItsPlane) {
    // An arc of cameras one of which stands far in: lines past it cross the strip twice.
    Points centres;
    for (int i = 0; i < 9; ++i) {
        const double azimuth = 0.15 * (i - 4);
        const double distance = i == 4 ? 2.55 : 3.4;
        centres.emplace_back(distance * std::cos(azimuth), distance * std::sin(azimuth), 0.0);
    }
    std::mt19937 random(4);
    const Capture capture = capture_of(centres, Eigen::Vector3d::Zero(),
                                       points_in_ball(400, Eigen::Vector3d::Zero(), 1.5, random));
    const BuiltCameraMesh without =
        build_camera_mesh(capture, all_views(capture), {.repair = false});
    ASSERT_EQ(without.mesh.construction, MeshConstruction::kLine);
    EXPECT_LT(without.evidence.kernel_radius_over_scene_radius, 1);
    CameraMesh mesh = without.mesh;
    Points scene;
    for (const ScenePoint& point : capture.points) scene.push_back(point.position_in_world);
    const auto centre_of_view = [&](int view) { return centres[static_cast<std::size_t>(view)]; };
    const RepairReport report = repair_kernel(mesh, {scene, centre_of_view});
    EXPECT_GE(scene_clearance(mesh, scene_hull(scene, 1.0)), 0);
    EXPECT_GT(report.slide.cameras_slid, 0);
    EXPECT_GT(report.epipole_loss.worst, 0);
    for (const CameraMesh::Vertex& vertex : mesh.vertices) {
        EXPECT_TRUE(vertex.position_in_world.allFinite());
    }
}

TEST(Repair, TakesTheLargestPartOfASceneThatIsTooWideForTheCameras) {
    std::mt19937 random(6);
    CameraMesh mesh = closed_mesh(rough_sphere(60, 0.1, 2));
    Points scene = points_in_ball(850, Eigen::Vector3d::Zero(), 0.5, random);
    for (const Eigen::Vector3d& far : points_in_ball(150, Eigen::Vector3d::Zero(), 1.0, random)) {
        scene.push_back(far.normalized() * 1.8);
    }
    const CameraMesh before = mesh;
    const auto centre_of_view = [&](int view) {
        return before.vertices[static_cast<std::size_t>(view)].position_in_world;
    };
    const RepairReport report = repair_kernel(mesh, {scene, centre_of_view});
    EXPECT_EQ(report.epipole_loss.worst > 0, report.slide.cameras_slid > 0);
    EXPECT_LT(scene_clearance(mesh, scene_hull(scene, 1.0)), 0);
    EXPECT_GE(scene_clearance(mesh, ball_hull(0.4)), 0);
}

/// Distances vary by a quarter, each on its own, and the scene fills half of the mean distance:
/// what flips cannot bring in, slides do, whatever they cost a camera of its own rays.
TEST(Repair, LeavesEveryRayToARoughlyPhotographedSceneExactlyOneFace) {
    int slid = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        std::mt19937 random(seed);
        const Points targets = points_in_ball(400, Eigen::Vector3d::Zero(), 0.5, random);
        const int count = 20 + 15 * static_cast<int>(seed);
        const Capture capture =
            capture_of(rough_sphere(count, 0.25, seed), Eigen::Vector3d::Zero(), targets);
        const BuiltCameraMesh built = build_camera_mesh(capture, all_views(capture), {});
        const CameraMeshEvidence& evidence = built.evidence;
        EXPECT_EQ(evidence.cameras_kept, count) << "seed " << seed;
        EXPECT_GE(evidence.kernel_radius_over_scene_radius, 1) << "seed " << seed;
        EXPECT_EQ(evidence.faces_with_scene_outside, 0) << "seed " << seed;
        EXPECT_LE(evidence.worst_epipole_loss, evidence.epipole_loss_bound + 1e-9);
        slid += evidence.cameras_slid > 0 ? 1 : 0;
        for (const Eigen::Vector3d& target : targets) {
            EXPECT_EQ(entering_faces(built.mesh, target, random_direction(random)), 1)
                << "seed " << seed;
        }
    }
    EXPECT_GT(slid, 0);
}

}  // namespace
}  // namespace lumi
