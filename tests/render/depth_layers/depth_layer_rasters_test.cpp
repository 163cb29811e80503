#include "render/depth_layers/depth_layer_rasters.h"

#include <gtest/gtest.h>

#include "render/depth_layers/depth_layer_painter.h"
#include "render/depth_mesh/view_depth_mesh.h"
#include "render/reference/depth_raster.h"
#include "render/transfer/view_geometry.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr double kMaxInverseDepth = 100;

std::vector<std::shared_ptr<const DepthMesh>> meshes_of(const Lumigraph& lumigraph) {
    const std::vector<ViewGeometry> geometries = view_geometries(lumigraph);
    std::vector<std::shared_ptr<const DepthMesh>> meshes;
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i)
        meshes.push_back(depth_mesh_of(lumigraph.views[i], max_disparity_px(geometries[i])));
    return meshes;
}

/// What a texel says.
EyeDepth read(float texel) {
    if (texel >= 1.0F) return {};
    const int kind = static_cast<int>(static_cast<double>(texel) / kDepthKindStep);
    const double share = (static_cast<double>(texel) - kDepthKindStep * kind) / kDepthKindWidth;
    return {kMaxInverseDepth * (1 - share), static_cast<DepthKind>(kind)};
}

/// Share of the pixels that are not as they are in plain code. Those on the sides of triangles may
/// be of either.
double unlike_share(const Lumigraph& lumigraph, const Eye& eye) {
    const auto meshes = meshes_of(lumigraph);
    DepthLayerRasters rasters(lumigraph.views, meshes, kMaxInverseDepth);
    const int width = eye.camera.width_px;
    const int height = eye.camera.height_px;
    const int layers = static_cast<int>(lumigraph.views.size());
    std::vector<DepthLayerDraw> draws;
    for (int view = 0; view < layers; ++view) {
        const auto& begins = meshes[static_cast<std::size_t>(view)]->kind_begin;
        for (int kind = 0; kind < kDepthKinds; ++kind) {
            const auto k = static_cast<std::size_t>(kind);
            draws.push_back({view, 0, 0, width, view, kind, begins[k], begins[k + 1] - begins[k]});
        }
    }
    const std::vector<float>& texels = rasters.draw({eye, 1.0, 1}, draws, layers);
    int unlike = 0;
    for (int view = 0; view < layers; ++view) {
        const auto v = static_cast<std::size_t>(view);
        const Image<EyeDepth> expected = rasterise(*meshes[v], lumigraph.views[v], eye);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const int row = view * height + height - 1 - y;
                const EyeDepth got = read(texels[static_cast<std::size_t>(row * width + x)]);
                const EyeDepth& want = expected(x, y);
                if (want.inverse_depth > kMaxInverseDepth) continue;  // Too near to be drawn.
                const bool is_same =
                    got.is_known() == want.is_known() &&
                    (!got.is_known() ||
                     (got.kind == want.kind && std::abs(got.inverse_depth - want.inverse_depth) <
                                                   1e-3 * (1 + want.inverse_depth)));
                unlike += is_same ? 0 : 1;
            }
        }
    }
    return static_cast<double>(unlike) / (layers * width * height);
}

TEST(DepthLayerRasters, AreWhatPlainCodeDraws) {
    const Camera camera = pinhole_camera(50, 40, 45);
    const Lumigraph wall = card_before_wall();
    const Lumigraph ball = ball_in_sky();
    for (const Eye& eye : {eye_at({0.2, 0.1, 0}, {0, 0, 4}, camera),
                           eye_at({0.3, -0.2, 2.7}, {0, 0, 4}, camera),      // By the card,
                           eye_at({0.02, 0.01, 2.99}, {1, 0.2, 3}, camera),  // along it,
                           eye_at({0, 0, 4.5}, {0.5, 0, 0}, camera),         // behind it,
                           eye_at({0, 0, 9}, {0, 0, 4}, camera)})            // and behind the wall.
        EXPECT_LT(unlike_share(wall, eye), 0.004)
            << centre_in_world(eye.cam_from_world).transpose();
    for (const Eye& eye :
         {eye_at({0, 0.5, 3}, {0, 0, 0}, camera), eye_at({0.4, 0.1, 1.1}, {0, 0, 0}, camera),
          eye_at({0.1, 0.2, 0.3}, {1, 0, 0}, camera), eye_at({0, 0, 30}, {0, 0, 0}, camera)})
        EXPECT_LT(unlike_share(ball, eye), 0.004)
            << centre_in_world(eye.cam_from_world).transpose();
}

}  // namespace
}  // namespace lumi
