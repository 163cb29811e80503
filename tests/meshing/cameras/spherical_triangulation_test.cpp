#include "meshing/cameras/spherical_triangulation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <set>

#include "meshing/cameras/border.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {
namespace {

using Faces = std::vector<std::array<int, 3>>;

std::set<int> corners_of(const Faces& faces) {
    std::set<int> corners;
    for (const auto& face : faces) corners.insert(face.begin(), face.end());
    return corners;
}

const Eigen::Vector3d& at(const Points& directions, int index) {
    return directions[static_cast<std::size_t>(index)];
}

TEST(SphericalTriangulation, IsTheDelaunayTriangulationByBruteForce) {
    std::mt19937 random(3);
    Points directions;
    for (int i = 0; i < 60; ++i) directions.push_back(random_direction(random));
    const Faces faces = spherical_triangulation(directions);
    EXPECT_EQ(faces.size(), 2 * directions.size() - 4);  // Euler
    EXPECT_EQ(corners_of(faces).size(), directions.size());
    EXPECT_TRUE(border_edges(faces).empty());
    for (const auto& face : faces) {
        const Eigen::Vector3d& a = at(directions, face[0]);
        const Eigen::Vector3d normal =
            (at(directions, face[1]) - a).cross(at(directions, face[2]) - a);
        for (const Eigen::Vector3d& other : directions) {
            EXPECT_LE(normal.dot(other - a), 1e-12);  // outside every circumscribed cap
        }
    }
}

TEST(SphericalTriangulation, KeepsDirectionsThatAlmostCoincide) {
    Points directions = sphere_directions(30, -1);
    for (const double apart : {1e-3, 1e-5, 1e-6}) {
        directions.push_back((directions[7] + apart * Eigen::Vector3d(1, 0.3, -0.2)).normalized());
    }
    EXPECT_EQ(corners_of(spherical_triangulation(directions)).size(), directions.size());
}

TEST(SphericalTriangulation, OfOnePlaneIsEmpty) {
    Points ring;
    for (int i = 0; i < 12; ++i) ring.emplace_back(std::cos(i * 0.5), std::sin(i * 0.5), 0.0);
    EXPECT_TRUE(spherical_triangulation(ring).empty());
    EXPECT_TRUE(spherical_triangulation({ring[0], ring[1], ring[2]}).empty());
    EXPECT_TRUE(spherical_triangulation({}).empty());
}

TEST(OpenTriangulation, IsADiskOverAllDirectionsWhoseFacesLookOutward) {
    const Points dome = sphere_directions(80, 0.0);
    const Faces faces = open_triangulation(dome, -Eigen::Vector3d::UnitZ());
    const auto border = border_edges(faces);
    ASSERT_GE(border.size(), 3U);
    EXPECT_EQ(corners_of(faces).size(), dome.size());
    // Euler's formula for a disk: vertices - edges + faces = 1.
    const std::size_t edges = (3 * faces.size() + border.size()) / 2;
    EXPECT_EQ(dome.size() + faces.size(), edges + 1);
    for (const auto& face : faces) {
        const double volume = at(dome, face[0]).dot(at(dome, face[1]).cross(at(dome, face[2])));
        EXPECT_GT(volume, 0);
    }
}

TEST(BorderEdges, FormOneClosedLoop) {
    const Faces faces = open_triangulation(sphere_directions(80, 0.3), -Eigen::Vector3d::UnitZ());
    const auto border = border_edges(faces);
    std::set<int> starts;
    std::set<int> ends;
    for (const auto& [from, to] : border) {
        starts.insert(from);
        ends.insert(to);
    }
    EXPECT_EQ(starts.size(), border.size());
    EXPECT_EQ(starts, ends);
}

}  // namespace
}  // namespace lumi
