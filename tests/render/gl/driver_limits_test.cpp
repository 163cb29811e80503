#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include <functional>
#include <string>

#include "calib/work/error.h"
#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "render/lumigraph/package.h"
#include "render/modes/per_pixel.h"
#include "render/renderer/offscreen_renderer.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/gl/small_driver.h"

namespace lumi {
namespace {

constexpr int kMostSide_px = 2048;
constexpr int kMostLayers = 64;

using testing::AllOf;
using testing::HasSubstr;

/// Of small photographs in a plane before the wall.
Lumigraph wall_seen_by(int views) {
    constexpr int kInARow = 13;
    std::vector<Eye> cameras;
    for (int i = 0; i < views; ++i)
        cameras.push_back(eye_at({0.1 * (i % kInARow), 0.1 * (i / kInARow), 0}, {0.6, 0.2, 4},
                                 pinhole_camera(20, 16, 18)));
    return photographed(AnalyticScene::kCardBeforeWall, cameras);
}

/// As it comes from a package.
Lumigraph written_and_read(Lumigraph lumigraph) {
    const ScratchFolder scratch;
    lumigraph.name = "wall";
    write_package(scratch / "wall.lumi", lumigraph, {});
    return read_package(scratch / "wall.lumi");
}

std::string message_of_limit(const std::function<void()>& asks_too_much) {
    try {
        asks_too_much();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-GL-LIMIT");
        EXPECT_FALSE(error.advice().empty());
        return error.what();
    }
    ADD_FAILURE() << "expected E-GL-LIMIT";
    return {};
}

std::string message_of_opening(const Lumigraph& lumigraph) {
    return message_of_limit([&] { const OffscreenRenderer renderer(lumigraph); });
}

TEST(DriverLimitsGl, APackageOfMoreViewsThanADriverHoldsIsRefusedWithBothNumbers) {
    const Lumigraph lumigraph = written_and_read(wall_seen_by(kMostLayers + 1));
    const SmallDriver driver(kMostSide_px, kMostLayers);
    EXPECT_THAT(message_of_opening(lumigraph), AllOf(HasSubstr("65 photographs"), HasSubstr("64")));
    EXPECT_EQ(SmallDriver::refused(), 0);
}

TEST(DriverLimitsGl, APackageOfAsManyViewsAsADriverHoldsIsDrawnInEveryMode) {
    const Lumigraph lumigraph = written_and_read(wall_seen_by(kMostLayers));
    const Eye eye = eye_at({0.63, 0.21, 0}, {0.6, 0.2, 4}, pinhole_camera(40, 32, 36));
    std::vector<ColorImage> expected;
    for (const RenderMode mode : all_render_modes())
        expected.push_back(OffscreenRenderer(lumigraph).draw(eye, {.mode = mode}).color);
    const SmallDriver driver(kMostSide_px, kMostLayers);
    OffscreenRenderer renderer(lumigraph);
    for (const RenderMode mode : all_render_modes())
        EXPECT_EQ(renderer.draw(eye, {.mode = mode}).color,
                  expected[static_cast<std::size_t>(mode)])
            << name_of(mode);
    EXPECT_EQ(SmallDriver::refused(), 0);
}

TEST(DriverLimitsGl, APhotographThatIsTooLongIsNamed) {
    Lumigraph lumigraph = card_before_wall();
    LumigraphView& view = lumigraph.views[3];
    view.camera = resized(view.camera, kMostSide_px, 16);
    view.photograph = ColorImage(kMostSide_px, 16);
    const SmallDriver driver(kMostSide_px, kMostLayers);
    // It has a gutter around it.
    EXPECT_THAT(message_of_opening(lumigraph),
                AllOf(HasSubstr("view3"), HasSubstr("2050 pixels"), HasSubstr("2048")));
    EXPECT_EQ(SmallDriver::refused(), 0);
}

TEST(DriverLimitsGl, ADepthMapThatIsTooLongIsNamed) {
    Lumigraph lumigraph = card_before_wall();
    lumigraph.views[3].depth = {FloatImage(16, kMostSide_px + 1), GrayImage(16, kMostSide_px + 1)};
    const SmallDriver driver(kMostSide_px, kMostLayers);
    EXPECT_THAT(message_of_opening(lumigraph),
                AllOf(HasSubstr("the depth map of view3"), HasSubstr("2049"), HasSubstr("2048")));
    EXPECT_EQ(SmallDriver::refused(), 0);
}

/// As long as the driver draws, of few pixels.
Eye eye_of_width(int width_px) {
    return eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(width_px, 6, width_px));
}

TEST(DriverLimitsGl, TheLongestFramesAreDrawnInEveryMode) {
    Lumigraph lumigraph = card_before_wall();
    lumigraph.drawing.fills_holes = true;
    for (const double block_px : {kLeastDepthBlock_px, kMaxDepthBlock_px}) {
        lumigraph.drawing.depth_block_px = block_px;
        const SmallDriver driver(kMostSide_px, kMostLayers);
        OffscreenRenderer renderer(lumigraph);
        for (const RenderMode mode : all_render_modes()) {
            RenderOptions options{.mode = mode};
            EXPECT_EQ(renderer.draw(eye_of_width(kMostSide_px), options).color.width(),
                      kMostSide_px);
            options.supersample = true;
            EXPECT_EQ(renderer.draw(eye_of_width(kMostSide_px / 2), options).color.width(),
                      kMostSide_px / 2);
        }
        EXPECT_EQ(SmallDriver::refused(), 0);
    }
}

TEST(DriverLimitsGl, DepthThatOpenGlDrawsKeepsToThem) {
    const Eye eye = eye_of_width(kMostSide_px);
    const SmallDriver driver(kMostSide_px, kMostLayers);
    const HeadlessContext context;
    const UploadedLumigraph uploaded(card_before_wall());
    Framebuffer framebuffer;
    framebuffer.attach_color(eye.camera.width_px, eye.camera.height_px);
    framebuffer.bind();
    PerPixel mode(uploaded, DepthLayers::DrawnBy::kOpenGl);
    mode.draw(eye, {}, {0, 0, eye.camera.width_px, eye.camera.height_px});
    EXPECT_EQ(SmallDriver::refused(), 0);
}

TEST(DriverLimitsGl, LongerFramesAreRefusedWithBothSizes) {
    const SmallDriver driver(kMostSide_px, kMostLayers);
    OffscreenRenderer renderer(card_before_wall());
    EXPECT_THAT(message_of_limit(
                    [&] { (void)renderer.draw(eye_of_width(kMostSide_px + 1), RenderOptions{}); }),
                AllOf(HasSubstr("2049x6"), HasSubstr("2048")));
    EXPECT_THAT(message_of_limit([&] {
                    (void)renderer.draw(eye_of_width(kMostSide_px / 2 + 1), {.supersample = true});
                }),
                AllOf(HasSubstr("2050x12"), HasSubstr("2048")));
    EXPECT_EQ(SmallDriver::refused(), 0);
}

}  // namespace
}  // namespace lumi
