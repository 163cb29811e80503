#include "meshing/surface/points_ply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace lumi {
namespace {

/// On a square meter, ten centimetres apart, around a place.
std::vector<ScenePoint> points_around(const Eigen::Vector3d& place) {
    std::vector<ScenePoint> points;
    for (int i = 0; i < 100; ++i) {
        ScenePoint& point = points.emplace_back();
        point.position_in_world = place + Eigen::Vector3d(0.1 * (i % 10), 0.1 * (i / 10), 0.25);
        point.color = {static_cast<std::uint8_t>(i), 2, 3};
    }
    return points;
}

struct PlyParts {
    std::string header;
    Bytes body;
};

PlyParts parts_of(const Bytes& ply) {
    const std::string text(ply.begin(), ply.end());
    const std::string end = "end_header\n";
    const std::size_t at = text.find(end) + end.size();
    return {text.substr(0, at), Bytes(ply.begin() + static_cast<std::ptrdiff_t>(at), ply.end())};
}

TEST(PointsPly, FloatsHoldPlacesNearTheOrigin) {
    std::vector<ScenePoint> points = points_around({0.3, -0.7, 4});
    const PlyParts near = parts_of(points_ply(points));
    EXPECT_THAT(near.header, testing::HasSubstr("element vertex 100\nproperty float x\n"));
    EXPECT_EQ(near.body.size(), 100 * 15U);
    points.back().position_in_world *= 1e9;
    points.push_back(points.front());
    EXPECT_THAT(parts_of(points_ply(points)).header, testing::HasSubstr("property float x\n"))
        << "one point astray and one found twice tell nothing of the others";
    EXPECT_THAT(parts_of(points_ply({})).header, testing::HasSubstr("element vertex 0\n"));
}

TEST(PointsPly, DoublesKeepPlacesInSurveyedCoordinates) {
    const std::vector<ScenePoint> points = points_around({500000, 5400000, 300});
    const PlyParts far = parts_of(points_ply(points));
    EXPECT_THAT(far.header, testing::HasSubstr("property double x\nproperty double y\n"));
    ASSERT_EQ(far.body.size(), points.size() * 27);
    for (std::size_t i = 0; i < points.size(); ++i) {
        Eigen::Vector3d place;
        std::memcpy(place.data(), &far.body[27 * i], 3 * sizeof(double));
        EXPECT_EQ(place, points[i].position_in_world) << i;
        EXPECT_EQ(far.body[27 * i + 24], i);
    }
}

}  // namespace
}  // namespace lumi
