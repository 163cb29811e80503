#include "render/paths/path_through_views.h"

#include <gtest/gtest.h>

#include "render/paths/photograph_eye.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

TEST(PathThroughViews, StandsUprightWhereTheCameraWasTurned) {
    Lumigraph lumigraph = card_before_wall();
    for (LumigraphView& view : lumigraph.views) view.exif_orientation = 6;
    const auto count = static_cast<int>(lumigraph.views.size());
    const std::vector<Eye> path = path_through_views(lumigraph, count, 96, 128);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Eye expected = eye_at(lumigraph.views[i]);
        EXPECT_TRUE(path[i].cam_from_world.rotation.isApprox(expected.cam_from_world.rotation));
        EXPECT_TRUE(
            path[i].cam_from_world.translation.isApprox(expected.cam_from_world.translation));
    }
}

TEST(PathThroughViews, ShowsTheWholePhotographWhereverItsMiddleIs) {
    Lumigraph lumigraph = card_before_wall();
    Camera& camera = lumigraph.views.front().camera;
    camera.parameters[2] += 5;
    const Eye fitted =
        path_through_views(lumigraph, 2, 2 * camera.width_px, 3 * camera.height_px).front();
    EXPECT_DOUBLE_EQ(principal_point_px(fitted.camera).x(), 2 * principal_point_px(camera).x());
}

}  // namespace
}  // namespace lumi
