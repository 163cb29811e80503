#pragma once

#include <memory>

#include "calib/work/progress.h"
#include "render/depth_mesh/depth_triangulation.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// How closely a Lumigraph's depth meshes follow its depth.
[[nodiscard]] DepthMeshOptions depth_mesh_options(const Lumigraph& lumigraph);

/// The depth mesh that a view is drawn with: the one that came with it, if it was made for the
/// options' error, is no coarser than they allow, and for about `disparity_px` pixels a unit of
/// inverse depth (within a factor of 1.5); otherwise one made now. Either is rounded as in a
/// package, so that a view is drawn the same with and without its mesh there. Without depth, an
/// empty mesh.
[[nodiscard]] std::shared_ptr<const DepthMesh> depth_mesh_of(const LumigraphView& view,
                                                             double disparity_px,
                                                             const DepthMeshOptions& options);

/// Gives each view with depth the mesh that it will be drawn with, for a package to hold; rounds
/// the depth as a package does, of which the mesh is made. Views that have theirs keep it, where it
/// is as close as the Lumigraph wants it. On `threads` threads (0: all cores), with the same result
/// for any number.
void make_depth_meshes(Lumigraph& lumigraph, int threads, Progress& progress);

}  // namespace lumi
