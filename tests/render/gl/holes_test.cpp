#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "render/reference/reference_renderer.h"
#include "render/renderer/offscreen_renderer.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/frame_difference.h"

namespace lumi {
namespace {

/// Five cameras close together, from which the card hides the wall, and three that look at the wall
/// past the card: they are no use to an eye among the first but for what these do not see.
class Holes : public testing::Test {
 protected:
    [[nodiscard]] static Lumigraph hidden_wall() {
        const Camera wide = pinhole_camera(160, 120, 85);
        const Camera narrow = pinhole_camera(96, 72, 80);
        std::vector<Eye> cameras;
        for (const auto& [x, y] :
             {std::pair(-1.0, -0.1), std::pair(-0.9, 0.1), std::pair(-1.1, 0.1),
              std::pair(-1.0, 0.2), std::pair(-0.95, -0.2)})
            cameras.push_back(eye_at({x, y, 0}, {0, 0, 4.5}, wide));
        for (const auto& [x, y] : {std::pair(1.3, -0.3), std::pair(1.5, 0.3), std::pair(1.8, 0.0)})
            cameras.push_back(eye_at({x, y, 0.2}, {0, 0, 5}, narrow));
        Lumigraph lumigraph = photographed(AnalyticScene::kCardBeforeWall, cameras);
        lumigraph.drawing.depth_views = kLeastDepthViews;
        return lumigraph;
    }

    [[nodiscard]] static long covered(const Frame& frame) {
        return std::count(frame.coverage.pixels().begin(), frame.coverage.pixels().end(), 255);
    }

    /// Covered pixels that show another surface.
    [[nodiscard]] static long wrong(const Frame& frame, const ColorImage& ideal) {
        long count = 0;
        for (std::size_t i = 0; i < ideal.pixels().size(); ++i)
            if (frame.coverage.pixels()[i] != 0 &&
                std::abs(frame.color.pixels()[i].g - ideal.pixels()[i].g) > 40)
                ++count;
        return count;
    }

    Lumigraph lumigraph_ = hidden_wall();
    Eye eye_ = eye_at({-0.2, 0.05, -0.1}, {0, 0, 4.5}, pinhole_camera(160, 120, 130));
};

TEST_F(Holes, AreFilledFromViewsThatWereNotAskedForDepth) {
    const ColorImage ideal = ideal_photograph(AnalyticScene::kCardBeforeWall, eye_);
    const Frame before = OffscreenRenderer(lumigraph_).draw(eye_, {});
    lumigraph_.drawing.fills_holes = true;
    const Frame after = OffscreenRenderer(lumigraph_).draw(eye_, {});
    const long more = covered(after) - covered(before);
    EXPECT_GT(more, 500);
    // Over the card's outline, most of them.
    EXPECT_LT(wrong(after, ideal) - wrong(before, ideal), more / 4);
    EXPECT_LT(difference_between(after.color, ideal).mean,
              0.8 * difference_between(before.color, ideal).mean);
}

TEST_F(Holes, AreFilledWhereThatIsChosenLater) {
    OffscreenRenderer renderer(lumigraph_);
    const Frame before = renderer.draw(eye_, {});
    lumigraph_.drawing.fills_holes = true;
    renderer.choose(lumigraph_.drawing);
    const Frame after = renderer.draw(eye_, {});
    EXPECT_EQ(after.color, OffscreenRenderer(lumigraph_).draw(eye_, {}).color);
    EXPECT_NE(after.color.pixels(), before.color.pixels());
}

TEST_F(Holes, AreFilledAlikeByTheReference) {
    lumigraph_.drawing.fills_holes = true;
    for (const double block_px : {kLeastDepthBlock_px, kMaxDepthBlock_px}) {
        lumigraph_.drawing.depth_block_px = block_px;
        for (const GlApi api : {GlApi::kAny, GlApi::kEs}) {
            const Frame drawn = OffscreenRenderer(lumigraph_, api).draw(eye_, {});
            const Frame expected = draw_reference(lumigraph_, eye_, {});
            const FrameDifference difference = difference_between(drawn.color, expected.color);
            EXPECT_LE(difference.mean, 1.0) << block_px;
            EXPECT_LE(difference.share_beyond_two, 0.02) << block_px;
            EXPECT_NEAR(static_cast<double>(covered(drawn)), static_cast<double>(covered(expected)),
                        0.01 * static_cast<double>(expected.coverage.pixels().size()));
        }
    }
}

TEST(HolesGl, AreFoundInTheSameCellsAsInPlainCode) {
    Lumigraph lumigraph = ball_in_sky();
    lumigraph.drawing.fills_holes = true;
    OffscreenRenderer renderer(lumigraph);
    for (double angle = 0; angle < 6.2; angle += 0.4) {
        const Eye eye = eye_at({2.8 * std::cos(angle), 0.4, 2.8 * std::sin(angle)}, {0, 0, 0},
                               pinhole_camera(120, 90, 80));
        const Frame drawn = renderer.draw(eye, {});
        const Frame expected = draw_reference(lumigraph, eye, {});
        EXPECT_LE(difference_between(as_color(drawn.coverage), as_color(expected.coverage))
                      .share_beyond_two,
                  0.015)
            << angle;
    }
}

TEST_F(Holes, AreAllThatChanges) {
    const Frame before = OffscreenRenderer(lumigraph_).draw(eye_, {});
    lumigraph_.drawing.fills_holes = true;
    const Frame after = OffscreenRenderer(lumigraph_).draw(eye_, {});
    for (std::size_t i = 0; i < before.coverage.pixels().size(); ++i) {
        if (before.coverage.pixels()[i] != 255) continue;
        EXPECT_EQ(after.color.pixels()[i], before.color.pixels()[i]);
    }
}

TEST_F(Holes, AreMarkedInThePictureOfWeights) {
    const RenderOptions weights{.debug_picture = DebugPicture::kWeights};
    const Frame before = OffscreenRenderer(lumigraph_).draw(eye_, weights);
    lumigraph_.drawing.fills_holes = true;
    const Frame after = OffscreenRenderer(lumigraph_).draw(eye_, weights);
    int filled = 0;
    for (std::size_t i = 0; i < before.coverage.pixels().size(); ++i) {
        if (before.coverage.pixels()[i] != 0 || after.coverage.pixels()[i] == 0) continue;
        ++filled;
        EXPECT_EQ(after.color.pixels()[i], (Rgb8{255, 255, 255}));
    }
    EXPECT_GT(filled, 400);
}

TEST_F(Holes, FadeLikeTheRestBeyondTheCapture) {
    const RenderOptions fading{.fade_beyond_capture = true};
    const Frame before = OffscreenRenderer(lumigraph_).draw(eye_, fading);
    lumigraph_.drawing.fills_holes = true;
    EXPECT_EQ(OffscreenRenderer(lumigraph_).draw(eye_, fading).color, before.color);
}

}  // namespace
}  // namespace lumi
