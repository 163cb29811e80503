#include "meshing/fusion/front_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace lumi {
namespace {

/// Points of the plane z = 0, a unit apart but for a tenth, that face along -z.
std::vector<SurfacePoint> flat_points(int columns, int rows) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-0.1, 0.1);
    std::vector<SurfacePoint> points;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const bool is_border =
                row == 0 || column == 0 || row + 1 == rows || column + 1 == columns;
            const double x = is_border ? 0 : shift(random);
            const double y = is_border ? 0 : shift(random);
            points.push_back({{column + x, row + y, 0.0}, {0, 0, -1}, {}, 1.0F});
        }
    }
    return points;
}

Eigen::Vector3d doubled_area_vector(const std::vector<SurfacePoint>& points,
                                    const std::array<std::uint32_t, 3>& face) {
    const Eigen::Vector3d& a = points[face[0]].position;
    return (points[face[1]].position - a).cross(points[face[2]].position - a);
}

TEST(FrontSurface, CoversAFlatPatchOnceAndLooksWhereItsPointsDo) {
    const std::vector<SurfacePoint> points = flat_points(9, 7);
    // The point that CGAL adds beside the plane has another number each time.
    for (int run = 0; run < 50; ++run) {
        double area = 0;
        for (const auto& face : front_surface(points)) {
            const Eigen::Vector3d doubled = doubled_area_vector(points, face);
            ASSERT_LT(doubled.z(), 0);
            area += 0.5 * doubled.norm();
        }
        ASSERT_NEAR(area, 8.0 * 6.0, 1e-9);
    }
}

TEST(FrontSurface, LeavesOpenWhatIsWiderThanAFewSpacings) {
    std::vector<SurfacePoint> points = flat_points(5, 5);
    const std::size_t first = points.size();
    for (SurfacePoint point : flat_points(5, 5)) {
        point.position.x() += 4 + 3.6;
        points.push_back(point);
    }
    double area = 0;
    for (const auto& face : front_surface(points)) {
        EXPECT_EQ(face[0] < first, face[1] < first);
        EXPECT_EQ(face[0] < first, face[2] < first);
        area += 0.5 * doubled_area_vector(points, face).norm();
    }
    EXPECT_NEAR(area, 2 * 16.0, 1e-9);
}

}  // namespace
}  // namespace lumi
