#include "pipeline/evaluate/kept_back_rounds.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "tests/pipeline/studio.h"

namespace lumi {
namespace {

/// Where the eyes stand that were asked, round by round.
std::vector<std::vector<Eigen::Vector3d>> asked_of(int views, std::size_t& asked) {
    Studio studio = before_a_board(views, 0.1);
    studio.find_points();
    std::vector<std::vector<Eigen::Vector3d>> rounds;
    SilentProgress progress;
    asked = visit_kept_back(
        with_camera_mesh(studio), studio.capture, {}, "asking", progress,
        [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
            EXPECT_LT(others.views.size(), static_cast<std::size_t>(views));
            rounds.emplace_back();
            for (const PicturedEye& picture : pictures)
                rounds.back().push_back(centre_in_world(picture.eye.cam_from_world));
        });
    return rounds;
}

TEST(KeptBackRounds, AskEveryViewOfASmallCaptureOnce) {
    std::size_t asked = 0;
    std::set<std::array<double, 3>> places;
    for (const auto& round : asked_of(8, asked))
        for (const Eigen::Vector3d& place : round)
            EXPECT_TRUE(places.insert({place.x(), place.y(), place.z()}).second);
    EXPECT_EQ(asked, 8U);
    EXPECT_EQ(places.size(), 8U);
}

TEST(KeptBackRounds, EndWhenEnoughPicturesWereAsked) {
    std::size_t asked = 0;
    EXPECT_EQ(asked_of(18, asked).size(), 3U);
    EXPECT_EQ(asked, 9U);
}

TEST(KeptBackRounds, AskNobodyOfFewViews) {
    std::size_t asked = 1;
    EXPECT_TRUE(asked_of(7, asked).empty());
    EXPECT_EQ(asked, 0U);
}

}  // namespace
}  // namespace lumi
