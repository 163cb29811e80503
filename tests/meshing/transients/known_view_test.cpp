#include "meshing/transients/known_view.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

constexpr double kFocalPx = 320;
constexpr double kStep = 0.3;

/// The disparity of the view in the middle of five places, each photographed so often.
double disparity_in_the_middle(int shots) {
    const auto count = static_cast<std::size_t>(5 * shots);
    const std::vector<DepthMap> maps(count,
                                     {FloatImage(320, 240, 0.25F), GrayImage(320, 240, 255)});
    const std::vector<ColorImage> photographs(count, ColorImage(320, 240));
    std::vector<PicturedView> views;
    for (int i = 0; i < 5 * shots; ++i) {
        const auto at = static_cast<std::size_t>(i);
        PicturedView& view = views.emplace_back();
        view.photograph = &photographs[at];
        view.camera = pinhole_camera(320, 240, kFocalPx);
        const double x = kStep * (i / shots) + 1e-4 * (i % shots);
        view.cam_from_world.translation = {-x, 0, 0};
        view.depth = &maps[at];
    }
    return known_views(views, 400, 1)[count / 2].disparity_px_per_inverse_depth;
}

TEST(KnownViews, OfARowSeeWhatTheNearestFourSeeMove) {
    EXPECT_NEAR(disparity_in_the_middle(1), 2 * kStep * kFocalPx, 0.01);
}

TEST(KnownViews, OfABurstSeeWhatThoseOfOtherPlacesSeeMove) {
    EXPECT_NEAR(disparity_in_the_middle(5), kStep * kFocalPx, 0.2);
}

TEST(KnownViews, OfSmallPhotographsAreWitnessesForLargeOnes) {
    const DepthMap large_map{FloatImage(800, 600, 0.25F), GrayImage(800, 600, 255)};
    const DepthMap small_map{FloatImage(64, 48, 0.25F), GrayImage(64, 48, 255)};
    const ColorImage large_photograph(800, 600, {90, 80, 70});
    const ColorImage small_photograph(64, 48, {90, 80, 70});
    const Rigid3 aside{Eigen::Quaterniond::Identity(), {-kStep, 0, 0}};
    const std::vector<PicturedView> views{
        {&large_photograph, pinhole_camera(800, 600, 800), {}, &large_map},
        {&small_photograph, pinhole_camera(64, 48, 64), aside, &small_map}};
    const std::vector<KnownView> known = known_views(views, 800, 1);
    EXPECT_EQ(witnesses_of(known, 0).size(), 1U);
    EXPECT_EQ(witnesses_of(known, 1).size(), 1U);
}

}  // namespace
}  // namespace lumi
