#include "render/depth_layers/depth_layer_rasters.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "render/depth_layers/depth_kind_ranges.h"
#include "render/depth_mesh/view_depth_mesh.h"
#include "render/reference/depth_raster.h"
#include "render/transfer/view_geometry.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr double kMaxInverseDepth = 100;
/// Inverse depths of one surface differ by less, and the same in units of the depth buffer.
constexpr double kAgreeing = 0.002;
constexpr auto kAgreeingDepth = static_cast<float>(kDepthKindWidth * kAgreeing / kMaxInverseDepth);

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
    const bool is_behind_tear = kind == 0 && (std::bit_cast<std::uint32_t>(texel) & 1U) != 0;
    return {kMaxInverseDepth * (1 - share), static_cast<DepthKind>(kind), is_behind_tear};
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
    return a.kind == b.kind && a.is_behind_tear == b.is_behind_tear &&
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
    const std::vector<float>& texels =
        rasters.draw(eye, draws, kMaxInverseDepth, kAgreeingDepth, kLayers);
    int unlike = 0;
    for (int view = 0; view < kLayers; ++view) {
        const auto v = static_cast<std::size_t>(view);
        const Image<EyeDepth> expected =
            rasterise(*meshes[v], lumigraph.views[v], eye, kMaxInverseDepth, kAgreeing);
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

/// Whether a ray passes what the card, so many times as large, hides from the view.
bool passes_hidden(const Eigen::Vector3d& view_in_world, const Eigen::Vector3d& eye_in_world,
                   const Eigen::Vector3d& on_wall, double size) {
    constexpr int kSteps = 2000;
    for (int step = 0; step < kSteps; ++step) {
        const Eigen::Vector3d at =
            eye_in_world + (on_wall - eye_in_world) * (step / static_cast<double>(kSteps));
        const Eigen::Vector3d from_view = at - view_in_world;
        const Eigen::Vector3d on_card =
            view_in_world + from_view * ((3 - view_in_world.z()) / from_view.z());
        if (at.z() > 3 && std::abs(on_card.x()) < 0.7 * size && std::abs(on_card.y()) < 0.5 * size)
            return true;
    }
    return false;
}

struct Marks {
    int right = 0;  ///< Where the ray passes what is hidden.
    int none = 0;   ///< Rightly.
    int wrong = 0;
};

/// What is marked of the wall that the first view has seen.
Marks marks_of(const Lumigraph& wall, const Eye& eye) {
    const auto meshes = meshes_of(wall);
    DepthLayerRasters rasters(wall.views, meshes);
    const int width = eye.camera.width_px;
    const int height = eye.camera.height_px;
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    const Eigen::Vector3d view_in_world = centre_in_world(wall.views[0].cam_from_world);
    std::vector<DepthLayerDraw> draws;
    append_draws(0, 0, width, *meshes[0], draws);
    const std::vector<float>& texels =
        rasters.draw(eye, draws, kMaxInverseDepth, kAgreeingDepth, 1);
    Marks marks;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int texel = (height - 1 - y) * width + x;
            const EyeDepth depth =
                read(texels[static_cast<std::size_t>(DepthLayerRasters::kPacked * texel)]);
            if (!depth.is_known() || depth.kind != DepthKind::kSeen) continue;
            const Eigen::Vector3d direction =
                eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, {x + 0.5, y + 0.5});
            const double to_wall = (6 - eye_in_world.z()) / direction.z();
            if (std::abs(depth.inverse_depth * to_wall - 1) > 0.01) continue;  // It is the card.
            const Eigen::Vector3d on_wall = eye_in_world + direction * to_wall;
            // A sample of the depth map is a fiftieth of the card.
            const bool is_hidden = passes_hidden(view_in_world, eye_in_world, on_wall, 0.9);
            if (is_hidden != passes_hidden(view_in_world, eye_in_world, on_wall, 1.1)) continue;
            ++(depth.is_behind_tear != is_hidden ? marks.wrong
               : is_hidden                       ? marks.right
                                                 : marks.none);
        }
    }
    return marks;
}

TEST(DepthLayerRasters, AreMarkedWhereTheRayPassesWhatTheViewCannotSee) {
    const Lumigraph wall = card_before_wall();
    const Camera camera = pinhole_camera(96, 72, 60);
    // From beside the card, whose other side of the wall is seen through what the card hides.
    const Marks beside = marks_of(wall, eye_at({1.9, 0.1, 3.4}, {-1.5, 0, 6}, camera));
    EXPECT_GT(beside.right, 300);
    EXPECT_EQ(beside.wrong, 0);
    const Marks before = marks_of(wall, eye_at({0.4, -0.3, 0.2}, {0, 0, 6}, camera));
    EXPECT_GT(before.none, 300);
    EXPECT_EQ(before.wrong, 0);
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
        static_cast<void>(rasters.draw(eye, last_layer, kMaxInverseDepth, kAgreeingDepth, 4));
        const std::vector<float>& texels =
            rasters.draw(eye, draws, kMaxInverseDepth, kAgreeingDepth, layers);
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
