#include "pipeline/stages/used_views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/work/error.h"

namespace lumi {
namespace {

using testing::ElementsAre;

std::vector<Photograph> photographs_named(const std::vector<std::string>& names) {
    std::vector<Photograph> photographs;
    for (const std::string& name : names) {
        photographs.emplace_back();
        photographs.back().name = name;
    }
    return photographs;
}

/// Three views; one point seen by all, one by the first two, one without a track.
PosedPhotographs three_views() {
    PosedPhotographs photographs;
    photographs.capture.cameras = {pinhole_camera(64, 48, 50.0)};
    for (const char* name : {"a.jpg", "b.jpg", "c.jpg"}) {
        photographs.capture.views.push_back({name, 0, {}});
        photographs.picture_paths.emplace_back(std::string(name) + ".png");
    }
    photographs.capture.points.resize(3);
    photographs.capture.points[0].track = {{0, {1, 1}}, {1, {2, 2}}, {2, {3, 3}}};
    photographs.capture.points[1].track = {{0, {1, 1}}, {1, {2, 2}}};
    return photographs;
}

TEST(HeldOutNames, CountPhotographsInOrderOfName) {
    const auto photographs = photographs_named({"a", "b", "c", "d", "e"});
    EXPECT_THAT(held_out_names(photographs, {2, {}}), ElementsAre("a", "c", "e"));
    EXPECT_THAT(held_out_names(photographs, {0, {"d", "b"}}), ElementsAre("b", "d"));
    EXPECT_THAT(held_out_names(photographs, {}), ElementsAre());
}

TEST(HeldOutNames, RefuseANameThatIsNotThere) {
    try {
        static_cast<void>(held_out_names(photographs_named({"a"}), {0, {"x"}}));
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-EVAL-NAME");
    }
}

TEST(WithoutViews, NothingOfAHeldOutViewRemains) {
    const PosedPhotographs used = without_views(three_views(), {"b.jpg"});
    EXPECT_THAT(view_names(used.capture), ElementsAre("a.jpg", "c.jpg"));
    EXPECT_THAT(used.picture_paths, ElementsAre("a.jpg.png", "c.jpg.png"));
    // The second point is seen by one view only and goes; the third never had a track and stays.
    ASSERT_EQ(used.capture.points.size(), 2U);
    ASSERT_EQ(used.capture.points[0].track.size(), 2U);
    EXPECT_EQ(used.capture.points[0].track[1].view_index, 1);
    EXPECT_EQ(used.capture.points[0].track[1].pixel, Eigen::Vector2d(3, 3));
    EXPECT_TRUE(used.capture.points[1].track.empty());
}

TEST(OnlyViews, IsTheOtherHalf) {
    const PosedPhotographs held_out = only_views(three_views(), {"b.jpg"});
    EXPECT_THAT(view_names(held_out.capture), ElementsAre("b.jpg"));
    EXPECT_THAT(held_out.picture_paths, ElementsAre("b.jpg.png"));
}

}  // namespace
}  // namespace lumi
