#include <gtest/gtest.h>

#include "render/paths/photograph_eye.h"
#include "render/viewer/window_input.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

TEST(TurningAbout, ThePivotIsWhatIsUnderTheCursorAndTheEyeStays) {
    const SyntheticCapture scene = textured_box_scene();
    const Lumigraph lumigraph = exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    const LumigraphView& view = lumigraph.views[4];
    const ViewerState state = first_state(lumigraph, {});
    for (const auto& [x, y] : {std::pair{20, 30}, {80, 60}, {81, 20}, {140, 100}}) {
        Navigation navigation = snap_to(state.navigation, lumigraph, 4);
        // The window is twice as large as the photograph, and wider.
        const Eigen::Vector2d at(2 * x + 1 + 60, 2 * y + 1);
        turn_about(at, {440, 240}, lumigraph, navigation);
        const Eigen::Vector3d pivot_in_cam = view.cam_from_world * navigation.pivot_in_world;
        EXPECT_LT(
            (project(view.camera, pivot_in_cam).value() - Eigen::Vector2d(x + 0.5, y + 0.5)).norm(),
            1e-6);
        const double inverse_depth = static_cast<double>(view.depth.inverse_depth(x, y));
        EXPECT_NEAR(1 / pivot_in_cam.z(), inverse_depth, 0.02 * inverse_depth) << x << " " << y;
        EXPECT_EQ(navigation.eye.cam_from_world.translation, view.cam_from_world.translation);
    }
}

TEST(TurningAbout, ThePivotStaysWhereNoDepthIsKnown) {
    const SyntheticCapture scene = textured_box_scene();
    Lumigraph lumigraph = exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    const Navigation before = first_state(lumigraph, {}).navigation;
    for (LumigraphView& view : lumigraph.views) {
        view.depth = {};
        view.depth_mesh = nullptr;
    }
    EXPECT_EQ(turning_about(before, lumigraph, {20, 30}).pivot_in_world, before.pivot_in_world);
}

}  // namespace
}  // namespace lumi
