#include "render/faces/face_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "meshing/surface/camera_mesh.h"
#include "meshing/surface/nearest_cameras.h"
#include "render/faces/blend_strips.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

using WeightOfView = std::map<int, double>;

/// An octahedron whose corners are subdivided once and moved in and out by up to `jitter`: star
/// shaped, and neither convex nor, for much jitter, a kernel mesh. Every vertex is a view.
CameraMesh jittered_sphere(double jitter, unsigned seed) {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kClosed;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> radius(1 - jitter, 1 + jitter);
    std::map<std::array<int, 3>, int> index_of;
    const auto vertex = [&](const Eigen::Vector3i& at) {
        const auto [entry, is_new] =
            index_of.try_emplace({at.x(), at.y(), at.z()}, static_cast<int>(mesh.vertices.size()));
        if (is_new)
            mesh.vertices.push_back({radius(random) * at.cast<double>().normalized(),
                                     static_cast<int>(mesh.vertices.size())});
        return entry->second;
    };
    for (int octant = 0; octant < 8; ++octant) {
        const Eigen::Vector3i sign(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
        const std::array<Eigen::Vector3i, 6> at{{{2 * sign.x(), 0, 0},
                                                 {0, 2 * sign.y(), 0},
                                                 {0, 0, 2 * sign.z()},
                                                 {sign.x(), sign.y(), 0},
                                                 {0, sign.y(), sign.z()},
                                                 {sign.x(), 0, sign.z()}}};
        for (std::array<int, 3> face : {std::array{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}) {
            if (sign.prod() < 0) std::swap(face[1], face[2]);
            mesh.faces.push_back({vertex(at[static_cast<std::size_t>(face[0])]),
                                  vertex(at[static_cast<std::size_t>(face[1])]),
                                  vertex(at[static_cast<std::size_t>(face[2])])});
        }
    }
    return mesh;
}

double value_at(const Eigen::Vector3d& line, const Eigen::Vector2d& pixel) {
    return line.dot(pixel.homogeneous());
}

/// Distance in pixels to the nearest edge of any polygon: there, rounding decides.
bool is_near_an_edge(const std::vector<FacePolygon>& polygons, const Eigen::Vector2d& pixel) {
    for (const FacePolygon& polygon : polygons)
        for (const Eigen::Vector3d& line : polygon.side_lines)
            if (!line.isZero() && std::abs(value_at(line, pixel)) < 0.05 * line.head<2>().norm())
                return true;
    return false;
}

bool is_inside(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& pixel) {
    int left = 0;
    int right = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d edge = corners[(i + 1) % corners.size()] - corners[i];
        const Eigen::Vector2d to_pixel = pixel - corners[i];
        const double turn = edge.x() * to_pixel.y() - edge.y() * to_pixel.x();
        (turn < 0 ? left : right) += turn != 0 ? 1 : 0;
    }
    return left == 0 || right == 0;
}

WeightOfView by_view(const std::array<int, 3>& views, const std::array<double, 3>& weights) {
    WeightOfView result;
    for (std::size_t i = 0; i < 3; ++i)
        if (weights[i] > 1e-9) result[views[i]] += weights[i];
    return result;
}

/// What painting the polygons in turn leaves at the pixel.
std::optional<WeightOfView> painted_at(const std::vector<FacePolygon>& polygons,
                                       const Eigen::Vector2d& pixel) {
    std::optional<WeightOfView> painted;
    for (const FacePolygon& polygon : polygons)
        if (is_inside(polygon.corners_px, pixel))
            painted = by_view(polygon.view_indices, weights_at(polygon, pixel));
    return painted;
}

/// Returns how many pixels were covered.
int expect_polygons_equal_ray_weights(const CameraMesh& mesh, const Eye& eye,
                                      const std::string& where) {
    const std::vector<FacePolygon> polygons = face_polygons(mesh, eye);
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    int covered = 0;
    for (int y = 0; y < eye.camera.height_px; ++y) {
        for (int x = 0; x < eye.camera.width_px; ++x) {
            const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
            if (is_near_an_edge(polygons, pixel)) continue;
            const Eigen::Vector3d direction =
                eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, pixel);
            const auto expected = weights_of_ray(mesh, eye_in_world, direction);
            const auto painted = painted_at(polygons, pixel);
            EXPECT_EQ(painted.has_value(), expected.has_value())
                << where << " at " << x << ' ' << y;
            if (!painted || !expected) continue;
            ++covered;
            const WeightOfView wanted = by_view(expected->view_indices, expected->weights);
            EXPECT_EQ(painted->size(), wanted.size()) << where << " at " << x << ' ' << y;
            for (const auto& [view, weight] : wanted)
                EXPECT_NEAR(painted->contains(view) ? painted->at(view) : 0.0, weight, 1e-6)
                    << where << " at " << x << ' ' << y << " view " << view;
        }
    }
    return covered;
}

int doubly_covered_pixels(const std::vector<FacePolygon>& polygons) {
    int count = 0;
    for (int y = 0; y < 18; ++y) {
        for (int x = 0; x < 24; ++x) {
            const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
            const auto layers = std::count_if(
                polygons.begin(), polygons.end(),
                [&](const FacePolygon& polygon) { return is_inside(polygon.corners_px, pixel); });
            count += layers > 1 && !is_near_an_edge(polygons, pixel) ? 1 : 0;
        }
    }
    return count;
}

const Camera kCamera = pinhole_camera(24, 18, 16);

TEST(FacePolygons, EqualTheWeightsOfEachRayFromAnywhere) {
    for (const double jitter : {0.0, 0.1}) {
        const CameraMesh mesh = jittered_sphere(jitter, 7);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> coordinate(-2.5, 2.5);
        int covered = 0;
        for (int i = 0; i < 30; ++i) {
            const Eigen::Vector3d position(coordinate(random), coordinate(random),
                                           coordinate(random));
            covered += expect_polygons_equal_ray_weights(
                mesh, eye_at(position, {0.1, -0.05, 0.12}, kCamera),
                "jitter " + std::to_string(jitter) + " eye " + std::to_string(i));
        }
        EXPECT_GT(covered, 5000);
    }
}

TEST(FacePolygons, ChooseTheLastCrossingWhereAMeshIsEnteredTwice) {
    const CameraMesh mesh = jittered_sphere(0.8, 11);
    int overlaps = 0;
    int faces_in_pieces = 0;
    int covered = 0;
    for (int i = 0; i < 24; ++i) {
        const Eigen::Vector3d position(2 * std::cos(0.26 * i), std::sin(0.9 * i),
                                       2 * std::sin(0.26 * i));
        const Eye eye = eye_at(position, {0.3, 0.2, 0}, kCamera);
        covered += expect_polygons_equal_ray_weights(mesh, eye, "eye " + std::to_string(i));
        const std::vector<FacePolygon> polygons = face_polygons(mesh, eye);
        overlaps += doubly_covered_pixels(polygons);
        std::set<int> faces;
        for (const FacePolygon& polygon : polygons)
            faces_in_pieces += faces.insert(polygon.face_index).second ? 0 : 1;
    }
    EXPECT_GT(covered, 3000);
    EXPECT_EQ(overlaps, 0);
    EXPECT_GT(faces_in_pieces, 10) << "the mesh is meant to fold over itself";
}

TEST(FacePolygons, EqualTheWeightsOfEachRayFromEdgesAndFaces) {
    const CameraMesh mesh = jittered_sphere(0.1, 5);
    for (std::size_t face = 0; face < mesh.faces.size(); face += 3) {
        const auto corner = [&](std::size_t i) {
            return mesh.vertices[static_cast<std::size_t>(mesh.faces[face][i])].position_in_world;
        };
        const Eigen::Vector3d on_edge = 0.3 * corner(0) + 0.7 * corner(1);
        const Eigen::Vector3d on_face = 0.2 * corner(0) + 0.5 * corner(1) + 0.3 * corner(2);
        expect_polygons_equal_ray_weights(mesh, eye_at(on_edge, {0, 0.1, 0}, kCamera),
                                          "on an edge");
        expect_polygons_equal_ray_weights(mesh, eye_at(on_face, {0, 0.1, 0}, kCamera), "on a face");
    }
}

TEST(FacePolygons, GiveACameraAllTheWeightWhereItStands) {
    const CameraMesh mesh = jittered_sphere(0.1, 5);
    for (const CameraMesh::Vertex& vertex : mesh.vertices) {
        const auto polygons =
            face_polygons(mesh, eye_at(vertex.position_in_world, {0, 0, 0}, kCamera));
        for (int y = 0; y < kCamera.height_px; ++y) {
            for (int x = 0; x < kCamera.width_px; ++x) {
                const auto painted = painted_at(polygons, {x + 0.5, y + 0.5});
                ASSERT_TRUE(painted.has_value()) << vertex.view_index << ' ' << x << ' ' << y;
                EXPECT_EQ(*painted, (WeightOfView{{vertex.view_index, 1.0}}));
            }
        }
    }
}

TEST(FacePolygons, LeaveNoPixelEmptyForAnEyeInside) {
    const CameraMesh mesh = jittered_sphere(0.1, 9);
    const Camera camera = pinhole_camera(60, 40, 20);
    for (int i = 0; i < 20; ++i) {
        const Eigen::Vector3d position = 0.3 * Eigen::Vector3d(std::sin(i), std::cos(2 * i), 0.5);
        const auto polygons = face_polygons(mesh, eye_at(position, {0.4, -0.5, 2}, camera));
        for (int y = 0; y < camera.height_px; ++y)
            for (int x = 0; x < camera.width_px; ++x)
                ASSERT_TRUE(painted_at(polygons, {x + 0.5, y + 0.5}).has_value())
                    << i << ": " << x << ' ' << y;
    }
}

TEST(FacePolygons, WithoutFacesIsOneWithTheWeightsOfTheEye) {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kNearest;
    for (const int view : {4, 2, 7}) {
        const auto along = static_cast<double>(mesh.vertices.size());
        mesh.vertices.push_back({{0.1 * view, 0, along}, view});
    }
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(0, 0.3, 1.25), Eigen::Vector3d(0.4, 0, -2), Eigen::Vector3d(0, 0, 5)}) {
        const Eye eye = eye_at(place, {0, 0, 9}, kCamera);
        EXPECT_EQ(face_polygons(mesh, eye).size(), 1U);
        EXPECT_EQ(expect_polygons_equal_ray_weights(mesh, eye, "a walk"), 24 * 18);
    }
}

TEST(FacePolygons, WithoutFacesAreStripsWhereOneCameraIsAboutToBeExchanged) {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kNearest;
    for (int view = 0; view < 4; ++view)
        mesh.vertices.push_back({{0, 0, static_cast<double>(view)}, view});
    // Halfway between the first and the last of four.
    const Eye eye = eye_at({0, 0, 1.5}, {0, 0, 9}, kCamera);
    const auto polygons = face_polygons(mesh, eye);
    ASSERT_EQ(polygons.size(), 2U);
    const double middle = 0.5 * kCamera.width_px;
    for (const FacePolygon& polygon : polygons) {
        const bool has_first =
            std::count(polygon.view_indices.begin(), polygon.view_indices.end(), 0) > 0;
        const bool has_last =
            std::count(polygon.view_indices.begin(), polygon.view_indices.end(), 3) > 0;
        EXPECT_NE(has_first, has_last);
        for (const Eigen::Vector2d& corner : polygon.corners_px)
            EXPECT_TRUE(has_first ? corner.x() <= middle : corner.x() >= middle);
    }
    const std::vector<EyeBlend> blends = blends_of_eye(mesh, {0, 0, 1.5}, Eigen::Vector3d::UnitZ());
    const std::vector<int> ends = blend_strip_ends(blends, kCamera.width_px);
    for (int x = 0; x < kCamera.width_px; ++x) {
        const RayWeights& weights = blends[strip_at(ends, x + 0.5)].weights;
        const auto painted = painted_at(polygons, {x + 0.5, 3.5});
        ASSERT_TRUE(painted.has_value());
        for (const auto& [view, weight] : by_view(weights.view_indices, weights.weights))
            EXPECT_NEAR(painted->at(view), weight, 1e-12) << x;
    }
}

TEST(BlendStrips, AreTheSameInAPictureWidenedToWholeBlocks) {
    for (const int width : {1, 2, 3, 5, 79, 81}) {
        const int widened = width + width % 2;
        for (int i = 0; i <= 200; ++i) {
            const double share = i / 200.0;
            const std::vector<EyeBlend> blends{{{}, share}, {{}, 1 - share}};
            const std::vector<int> ends = blend_strip_ends(blends, width);
            const std::vector<int> in_blocks = blend_strip_ends(blends, widened);
            EXPECT_EQ(ends.back(), width);
            EXPECT_EQ(in_blocks.front() % 2, 0);
            for (int x = 0; x < width; ++x)
                EXPECT_EQ(strip_at(ends, x + 0.5), strip_at(in_blocks, x + 0.5))
                    << width << ' ' << share;
        }
    }
}

TEST(FacePolygons, OneViewFillsThePicture) {
    CameraMesh mesh;
    mesh.vertices.push_back({{1, 2, 3}, 4});
    const auto polygons = face_polygons(mesh, eye_at({0, 0, 0}, {0, 0, 1}, kCamera));
    ASSERT_EQ(polygons.size(), 1U);
    EXPECT_EQ(painted_at(polygons, {0.5, 17.5}), (WeightOfView{{4, 1.0}}));
}

TEST(FacePolygon, WeightsBesideItAreThoseOfTheNearestCorner) {
    // Polygons reach a little beyond their edges; the tip of a thin one is beyond all three.
    FacePolygon polygon;
    polygon.side_lines = {Eigen::Vector3d(0, 0, -1e-3), Eigen::Vector3d(0, 0, -1e-5),
                          Eigen::Vector3d(0, 0, -1e-4)};
    EXPECT_EQ(weights_at(polygon, {3, 4}), (std::array<double, 3>{0, 1, 0}));
}

}  // namespace
}  // namespace lumi
