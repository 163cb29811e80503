#include <gtest/gtest.h>

#include <algorithm>

#include "meshing/depth_models/multi_view_sweep.h"
#include "meshing/depth_models/pair_stereo.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

KnownDepthScene textured_wall(const InverseDepthRange& range) {
    return known_depth_scene(
        {{{0, 0, 2}, {0.2, 0.1, 1}, [](const auto&) { return true; }, noise_texture(0.08, 5)}},
        cross_of_centres(0.12), range);
}

TEST(UnboundedRange, TheSweepCoversARangeWhosePlanesNoIntegerCounts) {
    KnownDepthScene known = textured_wall({0.1, 1.2});
    DepthView& view = known.scene.views[0];
    const double pixels = view.disparity_px_per_inverse_depth;
    view.disparity_px_per_inverse_depth = 1e15;
    SweepMemory memory;
    const DepthMap map = multi_view_sweep(known.scene, 0, memory);
    view.disparity_px_per_inverse_depth = pixels;
    const FloatImage errors = errors_px(map, known.inverse_depths[0], view);
    const auto right = std::count_if(errors.pixels().begin(), errors.pixels().end(),
                                     [](float error_px) { return error_px <= 1.0F; });
    EXPECT_GT(static_cast<double>(right), 0.8 * 240 * 180);
}

TEST(UnboundedRange, PairsSayNothingOfDisparitiesThatTheirPicturesDoNotHold) {
    const KnownDepthScene known = textured_wall({0.0, 1e15});
    const DepthMap map = pair_stereo(known.scene, 0);
    EXPECT_EQ(map.confidence, GrayImage(240, 180));
}

}  // namespace
}  // namespace lumi
