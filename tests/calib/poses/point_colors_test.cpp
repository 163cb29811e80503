#include "calib/poses/point_colors.h"

#include <gtest/gtest.h>

#include "calib/pictures/image_io.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

/// Two views, of one color each, and one point that is seen where it is told.
class PointColors : public testing::Test {
 protected:
    PointColors() {
        write_png(folder_ / "0.png", ColorImage(20, 10, {200, 100, 40}));
        write_png(folder_ / "1.png", ColorImage(20, 10, {100, 50, 20}));
        capture_.cameras = {pinhole_camera(20, 10, 20)};
        capture_.views.resize(2);
        capture_.points.resize(1);
    }

    [[nodiscard]] Rgb8 color_seen_at(const std::vector<Observation>& track) {
        capture_.points[0].track = track;
        color_points(capture_, {folder_ / "0.png", folder_ / "1.png"}, 2);
        return capture_.points[0].color;
    }

    ScratchFolder folder_;
    Capture capture_;
};

TEST_F(PointColors, AreTheMeanOfWhatTheViewsShow) {
    EXPECT_EQ(color_seen_at({{0, {3.5, 4.5}}}), (Rgb8{200, 100, 40}));
    EXPECT_EQ(color_seen_at({{0, {3.5, 4.5}}, {1, {19.9, 0.1}}}), (Rgb8{150, 75, 30}));
}

TEST_F(PointColors, LeaveOutWhatIsSeenBesideThePicture) {
    EXPECT_EQ(color_seen_at({{0, {3.5, 4.5}}, {1, {-0.3, 5}}}), (Rgb8{200, 100, 40}));
    EXPECT_EQ(color_seen_at({{0, {20.2, 4.5}}, {1, {7, 5}}}), (Rgb8{100, 50, 20}));
}

TEST_F(PointColors, StayWhereEverythingIsSeenBesideThePictures) {
    capture_.points[0].color = {1, 2, 3};
    EXPECT_EQ(color_seen_at({{0, {3, 10.5}}, {1, {7, -2}}}), (Rgb8{1, 2, 3}));
}

}  // namespace
}  // namespace lumi
