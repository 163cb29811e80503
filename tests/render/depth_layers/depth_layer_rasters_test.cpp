#include "render/depth_layers/depth_layer_rasters.h"

#include <gtest/gtest.h>

#include "render/depth_layers/depth_kind_ranges.h"
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
        meshes.push_back(depth_mesh_of(lumigraph.views[i], max_disparity_px(geometries[i]), {}));
    return meshes;
}

/// What a texel says.
EyeDepth read(float texel) {
    if (texel >= 1.0F) return {};
    const int kind = static_cast<int>(static_cast<double>(texel) / kDepthKindStep);
    const double share = (static_cast<double>(texel) - kDepthKindStep * kind) / kDepthKindWidth;
    return {kMaxInverseDepth * (1 - share), static_cast<DepthKind>(kind)};
}

/// All of a view's mesh, into the layer.
void append_draws(int view, int layer, int width, const DepthMesh& mesh,
                  std::vector<DepthLayerDraw>& draws) {
    for (int kind = 0; kind < kDepthKinds; ++kind) {
        const auto k = static_cast<std::size_t>(kind);
        draws.push_back({layer, 0, width, view, kind, mesh.kind_begin[k],
                         mesh.kind_begin[k + 1] - mesh.kind_begin[k]});
    }
}

bool is_same(const EyeDepth& a, const EyeDepth& b) {
    if (!a.is_known() || !b.is_known()) return a.is_known() == b.is_known();
    return a.kind == b.kind &&
           std::abs(a.inverse_depth - b.inverse_depth) < 1e-3 * (1 + b.inverse_depth);
}

/// Share of the pixels of two views that are not as they are in plain code. Those on the sides of
/// triangles may be of either.
double unlike_share(const Lumigraph& lumigraph, const Eye& eye) {
    constexpr int kLayers = 2;
    const auto meshes = meshes_of(lumigraph);
    DepthLayerRasters rasters(lumigraph.views, meshes);
    const int width = eye.camera.width_px;
    const int height = eye.camera.height_px;
    std::vector<DepthLayerDraw> draws;
    for (int view = 0; view < kLayers; ++view)
        append_draws(view, view, width, *meshes[static_cast<std::size_t>(view)], draws);
    const std::vector<float>& texels = rasters.draw(eye, draws, kMaxInverseDepth, kLayers);
    int unlike = 0;
    for (int view = 0; view < kLayers; ++view) {
        const auto v = static_cast<std::size_t>(view);
        const Image<EyeDepth> expected = rasterise(*meshes[v], lumigraph.views[v], eye);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                if (expected(x, y).inverse_depth > kMaxInverseDepth) continue;  // Too near.
                const int texel = (height - 1 - y) * width + x;
                const auto at = static_cast<std::size_t>(DepthLayerRasters::kPacked * texel + view);
                unlike += is_same(read(texels[at]), expected(x, y)) ? 0 : 1;
            }
        }
    }
    return static_cast<double>(unlike) / (kLayers * width * height);
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

TEST(DepthLayerRasters, HaveNothingInLayersThatAreNotDrawn) {
    const Lumigraph wall = card_before_wall();
    const auto meshes = meshes_of(wall);
    DepthLayerRasters rasters(wall.views, meshes);
    const Eye eye = eye_at({0.2, 0.1, 0}, {0, 0, 4}, pinhole_camera(20, 15, 18));
    std::vector<DepthLayerDraw> draws;
    append_draws(1, 1, 20, *meshes[1], draws);
    std::vector<DepthLayerDraw> last_layer;
    append_draws(1, 3, 20, *meshes[1], last_layer);
    for (const int layers : {4, 2, 3}) {
        static_cast<void>(rasters.draw(eye, last_layer, kMaxInverseDepth, 4));
        const std::vector<float>& texels = rasters.draw(eye, draws, kMaxInverseDepth, layers);
        ASSERT_EQ(texels.size(), 20U * 15U * 4U);
        for (std::size_t i = 0; i < texels.size(); ++i) {
            if (i % 4 != 1) {
                EXPECT_EQ(texels[i], 1.0F) << layers << " layers";
            }
        }
        EXPECT_LT(texels[4 * (7 * 20 + 10) + 1], 1.0F);
    }
}

}  // namespace
}  // namespace lumi
