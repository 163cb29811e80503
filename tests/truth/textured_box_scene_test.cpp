#include "tests/truth/textured_box_scene.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace lumi {
namespace {

const SyntheticCapture& scene() {
    static const SyntheticCapture kScene = textured_box_scene();
    return kScene;
}

TEST(TexturedBoxScene, EveryPixelShowsASurface) {
    ASSERT_EQ(scene().depths.size(), 9u);
    for (const FloatImage& depth : scene().depths) {
        for (const float z : depth.pixels()) ASSERT_GT(z, 0.5f);
    }
}

TEST(TexturedBoxScene, ViewsStandInColumnsAndRows) {
    const auto centre = [](int column, int row) {
        const auto index = static_cast<std::size_t>(textured_box_view(column, row));
        return centre_in_world(scene().capture.views[index].cam_from_world);
    };
    for (int row = 0; row < 3; ++row) {
        EXPECT_LT(centre(0, row).x(), centre(1, row).x());
        EXPECT_LT(centre(1, row).x(), centre(2, row).x());
    }
    for (int column = 0; column < 3; ++column) {
        EXPECT_LT(centre(column, 0).z(), centre(column, 1).z());
        EXPECT_LT(centre(column, 1).z(), centre(column, 2).z());
    }
}

TEST(TexturedBoxScene, CameraMeshFacesOutwardsAndHoldsEveryCamera) {
    const CameraMesh mesh = textured_box_camera_mesh(scene().capture);
    validate(mesh, 9, "mesh");
    EXPECT_EQ(mesh.faces.size(), 8u);
    for (const CameraMesh::Vertex& vertex : mesh.vertices) {
        const Eigen::Vector3d towards_scene = mesh.scene_centre_in_world - vertex.position_in_world;
        const auto weights = weights_of_ray(mesh, vertex.position_in_world, towards_scene);
        ASSERT_TRUE(weights.has_value()) << "view " << vertex.view_index;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const bool is_own = weights->view_indices[corner] == vertex.view_index;
            EXPECT_NEAR(weights->weights[corner], is_own ? 1.0 : 0.0, 1e-9);
        }
    }
}

TEST(TexturedBoxScene, LumigraphCarriesExactDepthAndItsRange) {
    const Lumigraph lumigraph = exact_lumigraph(scene(), textured_box_camera_mesh(scene().capture));
    ASSERT_EQ(lumigraph.views.size(), 9u);
    const LumigraphView& view = lumigraph.views[3];
    EXPECT_EQ(view.photograph, scene().photographs[3]);
    EXPECT_EQ(view.depth.inverse_depth(70, 50), 1.0f / scene().depths[3](70, 50));
    EXPECT_EQ(view.depth.confidence(70, 50), 255);
    std::size_t outside = 0;
    for (const FloatImage& depth : scene().depths) {
        for (const float z : depth.pixels()) {
            const auto depth_of_pixel = static_cast<double>(z);
            if (depth_of_pixel < lumigraph.near_depth || depth_of_pixel > lumigraph.far_depth) {
                ++outside;
            }
        }
    }
    EXPECT_NEAR(static_cast<double>(outside) / (9.0 * 160 * 120), 0.02, 0.002);
}

}  // namespace
}  // namespace lumi
