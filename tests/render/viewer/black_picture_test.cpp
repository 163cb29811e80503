#include "render/viewer/black_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/paths/photograph_eye.h"
#include "render/renderer/offscreen_renderer.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

TEST(BlackPictureGl, IsToldExactlyWhereADebugPictureShowsNothing) {
    const SyntheticCapture scene = textured_box_scene();
    const Lumigraph whole = exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    Lumigraph flat = whole;
    for (LumigraphView& view : flat.views) view.depth = {};
    Eye eye = fitted_to(eye_at(whole.views[4]), 96, 72);
    eye.cam_from_world.translation.x() += 0.05;
    for (const Lumigraph& lumigraph : {whole, flat}) {
        OffscreenRenderer renderer(lumigraph);
        for (const RenderMode mode : all_render_modes()) {
            for (const DebugPicture picture : all_debug_pictures()) {
                const RenderOptions options{.mode = mode, .debug_picture = picture};
                const Frame frame = renderer.draw(eye, options);
                const auto& pixels = frame.color.pixels();
                const bool is_black =
                    std::all_of(pixels.begin(), pixels.end(),
                                [](const Rgb8& pixel) { return pixel == Rgb8{}; });
                EXPECT_EQ(is_black, !why_black(lumigraph, options).empty())
                    << name_of(mode) << " " << name_of(picture) << " " << lumigraph.has_depth();
            }
        }
    }
}

}  // namespace
}  // namespace lumi
