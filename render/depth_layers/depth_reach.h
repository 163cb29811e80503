#pragma once

#include <Eigen/Geometry>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The pixels and inverse depths of a depth mesh, in its view; empty for a mesh without vertices.
[[nodiscard]] Eigen::AlignedBox3d box_of(const DepthMesh& mesh);

/// The largest inverse depth in the eye of what lies in the box before it: 0 where nothing does,
/// infinite where the box reaches to the eye's own plane, so that there is no such bound.
[[nodiscard]] double depth_reach(const LumigraphView& view, const Eigen::AlignedBox3d& box,
                                 const Eye& eye);

}  // namespace lumi
