#include "render/faces/asked_views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <map>

namespace lumi {
namespace {

using ::testing::ElementsAre;

FacePolygon face_of(const std::array<int, 3>& views) {
    FacePolygon face;
    face.view_indices = views;
    face.side_lines = {Eigen::Vector3d(1, 0, 3), Eigen::Vector3d(0, 2, 1),
                       Eigen::Vector3d(0.5, 0.25, 2)};
    face.beyond_border = {0.0F, 1.0F, 0.0F};
    return face;
}

std::map<int, double> weights_by_view(const FacePolygon& face, const Eigen::Vector2d& pixel) {
    const std::array<double, 3> weights = weights_at(face, pixel);
    std::map<int, double> by_view;
    for (std::size_t k = 0; k < 3; ++k) by_view[face.view_indices[k]] = weights[k];
    return by_view;
}

TEST(AskedViews, ComeFirstAndKeepTheirOrder) {
    const auto ordered =
        asked_first({face_of({7, 3, 5}), face_of({3, 7, 5}), face_of({1, 2, 4})}, {5, 9, 7});
    EXPECT_THAT(ordered[0].view_indices, ElementsAre(7, 5, 3));
    EXPECT_THAT(ordered[1].view_indices, ElementsAre(7, 5, 3));
    EXPECT_THAT(ordered[2].view_indices, ElementsAre(1, 2, 4)) << "none is asked";
}

TEST(AskedViews, EachViewKeepsItsWeightsAndItsBorder) {
    const FacePolygon face = face_of({7, 3, 5});
    const FacePolygon ordered = asked_first({face}, {5, 3}).front();
    for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(2, 3), Eigen::Vector2d(11, 0.5)})
        EXPECT_EQ(weights_by_view(ordered, pixel), weights_by_view(face, pixel));
    EXPECT_THAT(ordered.view_indices, ElementsAre(3, 5, 7));
    EXPECT_THAT(ordered.beyond_border, ElementsAre(1.0F, 0.0F, 0.0F));
}

TEST(AskedViews, OthersAreCounted) {
    EXPECT_EQ(unasked_views({7, 3, 5}, {3, 5, 7, 9}), 0U);
    EXPECT_EQ(unasked_views({7, 3, 5}, {9, 5}), 2U);
    EXPECT_EQ(unasked_views({4, 4, 5}, {5, -1}), 2U) << "a camera named twice counts twice";
    EXPECT_EQ(unasked_views({7, 3, 5}, {}), 3U);
}

}  // namespace
}  // namespace lumi
