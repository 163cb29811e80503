#include <gtest/gtest.h>

#include "pipeline/gallery/gallery_pictures.h"

namespace lumi {
namespace {

/// Photographs in a row, a unit apart.
Lumigraph row_of_views(int count) {
    Lumigraph lumigraph;
    for (int i = 0; i < count; ++i) {
        LumigraphView view;
        view.camera = {40, 30, LensModel::kPinhole, {50, 50, 20, 15}};
        view.cam_from_world = {Eigen::Quaterniond::Identity(), {-1.0 * i, 0, 0}};
        lumigraph.views.push_back(std::move(view));
    }
    return lumigraph;
}

TEST(Gallery, TheEyeOfItsMethodsStandsHalfwayBetweenTwoPhotographs) {
    for (const auto& [views, expected] :
         {std::pair(2, 0.5), std::pair(5, 1.5), std::pair(28, 13.5)}) {
        const Eye eye = eye_between_photographs(row_of_views(views), 80, 60);
        EXPECT_NEAR(centre_in_world(eye.cam_from_world).x(), expected, 1e-9) << views;
    }
    const Eye alone = eye_between_photographs(row_of_views(1), 80, 60);
    EXPECT_NEAR(centre_in_world(alone.cam_from_world).norm(), 0, 1e-9);
}

}  // namespace
}  // namespace lumi
