#include "render/depth_mesh/view_depth_mesh.h"

#include <vector>

#include "calib/work/parallel_for.h"
#include "render/lumigraph/coded_depth_mesh.h"
#include "render/lumigraph/quantised_depth.h"
#include "render/transfer/view_geometry.h"

namespace lumi {
namespace {

/// A unit of inverse depth changes with the views around: where some are left out, meshes that were
/// made among all of them are fine or coarse enough for the others.
constexpr double kMostStretch = 1.5;

/// Networks are made for errors in single precision.
constexpr double kRounding = 1 + 1e-6;

bool is_made_for(const DepthMesh& mesh, const DepthMap& depth, double disparity_px,
                 const DepthMeshOptions& options) {
    return mesh.wanted_error_px == options.max_error_px &&
           mesh.error_px <= kRounding * most_error_px(options, is_of_noise(mesh, depth)) &&
           mesh.disparity_px <= kMostStretch * disparity_px &&
           disparity_px <= kMostStretch * mesh.disparity_px;
}

}  // namespace

DepthMeshOptions depth_mesh_options(const Lumigraph& lumigraph) {
    return {.max_noisy_error_px = lumigraph.noisy_depth_error_px};
}

std::shared_ptr<const DepthMesh> depth_mesh_of(const LumigraphView& view, double disparity_px,
                                               const DepthMeshOptions& options) {
    if (view.depth_mesh && is_made_for(*view.depth_mesh, view.depth, disparity_px, options))
        return view.depth_mesh;
    if (!view.has_depth()) return std::make_shared<const DepthMesh>();
    const DepthMesh mesh = triangulate(view.depth, view.camera, disparity_px, options);
    return std::make_shared<const DepthMesh>(
        decode(encode(mesh, view.camera), view.camera, view.name));
}

void make_depth_meshes(Lumigraph& lumigraph, int threads, Progress& progress) {
    const std::vector<ViewGeometry> geometries = view_geometries(lumigraph);
    const DepthMeshOptions options = depth_mesh_options(lumigraph);
    progress.begin("simplifying depth", lumigraph.views.size());
    parallel_for(static_cast<int>(lumigraph.views.size()), threads, [&](int i) {
        progress.throw_if_interrupted();
        LumigraphView& view = lumigraph.views[static_cast<std::size_t>(i)];
        if (view.has_depth()) {
            view.depth.inverse_depth = dequantise(quantise(view.depth.inverse_depth));
            view.depth_mesh = depth_mesh_of(
                view, max_disparity_px(geometries[static_cast<std::size_t>(i)]), options);
        }
        progress.advance();
    });
}

}  // namespace lumi
