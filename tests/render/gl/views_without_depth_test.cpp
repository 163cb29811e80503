#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "render/reference/depth_of_others.h"
#include "render/renderer/mode_reference.h"
#include "render/renderer/offscreen_renderer.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/frame_difference.h"

namespace lumi {
namespace {

constexpr AnalyticScene kScene = AnalyticScene::kCardBeforeWall;
/// In the middle of those around it: most rays are blended from it.
constexpr std::size_t kMiddle = 0;

Lumigraph without_depth_of(std::size_t view, Lumigraph lumigraph) {
    lumigraph.views[view].depth = {};
    return lumigraph;
}

Eye eye_at_view(const LumigraphView& view) { return {view.camera, view.cam_from_world}; }

std::vector<Eye> eyes_among_cameras() {
    std::vector<Eye> eyes;
    for (const double x : {-0.4, -0.2, 0.0, 0.2, 0.4})
        for (const double y : {-0.3, -0.1, 0.1, 0.3})
            eyes.push_back(eye_at({x, y, 0.02}, {0, 0, 4}, pinhole_camera(80, 60, 70)));
    return eyes;
}

double error_of(OffscreenRenderer& renderer, RenderMode mode) {
    double sum = 0;
    for (const Eye& eye : eyes_among_cameras())
        sum += difference_between(renderer.draw(eye, {.mode = mode}).color,
                                  ideal_photograph(kScene, eye))
                   .mean;
    return sum;
}

constexpr std::array kModesWithDepth{RenderMode::kPerPixel, RenderMode::kAdaptive,
                                     RenderMode::kPaper2001};

TEST(ViewsWithoutDepth, AreAsGoodInEveryModeAsIfTheyHadIt) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer with_all(lumigraph);
    OffscreenRenderer without_one(without_depth_of(kMiddle, lumigraph));
    for (const RenderMode mode : kModesWithDepth)
        EXPECT_LT(error_of(without_one, mode), 1.03 * error_of(with_all, mode)) << name_of(mode);
}

TEST(ViewsWithoutDepth, ShowTheirPhotographInTheirPlaceInEveryMode) {
    const Lumigraph lumigraph = card_before_wall();
    for (std::size_t view = 0; view < lumigraph.views.size(); ++view) {
        OffscreenRenderer renderer(without_depth_of(view, lumigraph));
        const Eye eye = eye_at_view(lumigraph.views[view]);
        for (const RenderMode mode : kModesWithDepth)
            EXPECT_LT(difference_between(renderer.draw(eye, {.mode = mode}).color,
                                         lumigraph.views[view].photograph)
                          .mean,
                      0.1)
                << name_of(mode) << " " << view;
    }
}

TEST(ViewsWithoutDepth, AreDrawnAsPlainCodeDoes) {
    const Lumigraph lumigraph = without_depth_of(kMiddle, card_before_wall());
    OffscreenRenderer renderer(lumigraph);
    const Eye eye = eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(80, 60, 70));
    for (const RenderMode mode : kModesWithDepth) {
        const FrameDifference difference =
            difference_between(renderer.draw(eye, {.mode = mode}).color,
                               draw_mode_reference(lumigraph, eye, {.mode = mode}).color);
        EXPECT_LE(difference.mean, 1.0) << name_of(mode);
        EXPECT_LE(difference.share_beyond_two, 0.02) << name_of(mode);
    }
}

TEST(ViewsWithoutDepth, AreDrawnAsPlainCodeDoesWhereNoneHasAny) {
    Lumigraph lumigraph = card_before_wall();
    for (LumigraphView& view : lumigraph.views) view.depth = {};
    OffscreenRenderer renderer(lumigraph);
    for (const Eye& eye : {eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(80, 60, 70)),
                           eye_at_view(lumigraph.views[kMiddle])}) {
        for (const RenderMode mode : all_render_modes()) {
            const FrameDifference difference =
                difference_between(renderer.draw(eye, {.mode = mode}).color,
                                   draw_mode_reference(lumigraph, eye, {.mode = mode}).color);
            EXPECT_LE(difference.mean, 1.0) << name_of(mode);
            EXPECT_LE(difference.share_beyond_two, 0.02) << name_of(mode);
        }
    }
}

TEST(ViewsWithoutDepth, AreGivenTheDepthThatIsThere) {
    const Lumigraph lumigraph = card_before_wall();
    const DepthMap& exact = lumigraph.views[kMiddle].depth;
    const Lumigraph lacking = without_depth_of(kMiddle, lumigraph);
    ASSERT_TRUE(lacks_depth(lacking));
    const Lumigraph whole = with_depth_of_others(lacking);
    EXPECT_FALSE(lacks_depth(whole));
    const DepthMap& given = whole.views[kMiddle].depth;
    int seen = 0;
    int wrong = 0;
    for (std::size_t i = 0; i < exact.inverse_depth.pixels().size(); ++i) {
        if (given.confidence.pixels()[i] == 0) continue;
        ++seen;
        // The card and the wall behind it are 1/6 apart.
        const float difference = given.inverse_depth.pixels()[i] - exact.inverse_depth.pixels()[i];
        wrong += std::abs(difference) > 0.01F ? 1 : 0;
    }
    EXPECT_GT(seen, 64 * 48 * 9 / 10);
    // Along the card's outline others' samples are up to a pixel wide.
    EXPECT_LT(wrong, 64 * 48 / 50);
    for (std::size_t view = 1; view < lumigraph.views.size(); ++view)
        EXPECT_EQ(whole.views[view].depth.inverse_depth, lumigraph.views[view].depth.inverse_depth);
}

TEST(ViewsWithoutDepth, StayWithoutWhereNoneHasAny) {
    Lumigraph lumigraph = card_before_wall();
    for (LumigraphView& view : lumigraph.views) view.depth = {};
    EXPECT_FALSE(lacks_depth(lumigraph));
    EXPECT_FALSE(with_depth_of_others(lumigraph).has_depth());
}

}  // namespace
}  // namespace lumi
