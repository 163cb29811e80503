#include "pipeline/evaluate/occlusion_effort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/pipeline/studio.h"

namespace lumi {
namespace {

OcclusionEffort effort_for(const Studio& studio) {
    SilentProgress progress;
    const Lumigraph lumigraph = with_camera_mesh(studio);
    KeptBackPhotographs photographs(lumigraph, studio.capture, {}, progress);
    return sufficient_occlusion_effort(photographs, lumigraph.drawing);
}

/// By up to this share, another in each square of a few samples.
void disturb_depth(Lumigraph& lumigraph, double share) {
    constexpr int kSquare = 6;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> factor(1 - share, 1 + share);
    for (LumigraphView& view : lumigraph.views) {
        FloatImage& depth = view.depth.inverse_depth;
        for (int top = 0; top < depth.height(); top += kSquare)
            for (int left = 0; left < depth.width(); left += kSquare) {
                const auto of_square = static_cast<float>(factor(random));
                for (int y = top; y < std::min(top + kSquare, depth.height()); ++y)
                    for (int x = left; x < std::min(left + kSquare, depth.width()); ++x)
                        depth(x, y) *= of_square;
            }
        view.depth_mesh = nullptr;
    }
}

/// What the mean of several views has less of.
void disturb_photographs(Lumigraph& lumigraph, int most_levels) {
    std::mt19937 random(12);
    std::uniform_int_distribution<int> noise(-most_levels, most_levels);
    const auto with_noise = [&](std::uint8_t level) {
        return static_cast<std::uint8_t>(std::clamp(level + noise(random), 0, 255));
    };
    for (LumigraphView& view : lumigraph.views)
        for (Rgb8& pixel : view.photograph.pixels())
            pixel = {with_noise(pixel.r), with_noise(pixel.g), with_noise(pixel.b)};
}

TEST(OcclusionEffort, TrustsDepthThatIsRight) {
    Studio studio = from_all_around(kBodiesInTheWay, 40);
    studio.find_points();
    const OcclusionEffort effort = effort_for(studio);
    EXPECT_EQ(effort.tolerance_px, kOcclusionTolerance_px);
    EXPECT_GT(effort.beside_px, kOcclusionTolerance_px);
    EXPECT_GE(effort.pictures, 8);
}

TEST(OcclusionEffort, TrustsNoisyDepthLess) {
    Studio studio = before_a_board(18, 0.6);
    studio.find_points();
    disturb_photographs(studio.lumigraph, 30);
    disturb_depth(studio.lumigraph, 0.3);
    const OcclusionEffort effort = effort_for(studio);
    EXPECT_GT(effort.tolerance_px, kOcclusionTolerance_px);
    EXPECT_EQ(effort.beside_px, kOcclusionTolerance_px);
    EXPECT_GT(effort.gains_db, effort.standard_error_db);
}

TEST(OcclusionEffort, IsTheUsualOfFewerThanEightViewsUnasked) {
    Studio studio = before_a_board(7, 0.04);
    studio.find_points();
    const OcclusionEffort effort = effort_for(studio);
    EXPECT_EQ(effort.tolerance_px, kOcclusionTolerance_px);
    EXPECT_EQ(effort.pictures, 0);
}

}  // namespace
}  // namespace lumi
