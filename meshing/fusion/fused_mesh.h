#pragma once

#include "meshing/fusion/surface_points.h"
#include "meshing/geometry/triangle_mesh.h"

namespace lumi {

/// One mesh of the scene from the depth of all views, and what speaks for it.
struct FusedMesh {
    TriangleMesh mesh;  ///< With normals and colours.
    std::uint64_t confident_pixels = 0;
    std::uint64_t agreeing_pixels = 0;
    double spacing_px = 0.0;
};

void validate(const SurfacePointOptions& options);

/// Points that views agree on (surface_points.h), and the surface through them (front_surface.h)
/// without scraps of it. Throws Error: E-FUSE-OPTION; E-FUSE-FEW where fewer than 100 points, or no
/// surface, come of it.
[[nodiscard]] FusedMesh fused_mesh(const std::vector<PicturedView>& views,
                                   const SurfacePointOptions& options, int threads,
                                   Progress& progress);

}  // namespace lumi
