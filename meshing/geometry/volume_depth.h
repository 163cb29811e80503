#pragma once

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/geometry/binary_volume.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Casts rays through a binary volume.
class VolumeCaster {
 public:
    explicit VolumeCaster(BinaryVolume volume);

    /// Depth as a view sees it: where the ray through the centre of each pixel enters the first
    /// solid cell. The ray visits every cell on its way and no other (Amanatides and Woo, "A fast
    /// voxel traversal algorithm for ray tracing", 1987). Confidence kKnown on the volume,
    /// kUnseen beside it. Throws Error (E-VOLUME-INSIDE) when the camera stands in a solid cell.
    [[nodiscard]] DepthMap depth(const DepthView& view) const;

 private:
    BinaryVolume volume_;
    Eigen::AlignedBox3i solid_cells_;  ///< Rays need not walk the rest; corners are cells.
};

}  // namespace lumi
