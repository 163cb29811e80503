#pragma once

#include <vector>

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// What other views know of the surroundings of a view, beyond the border of its picture: the
/// raster is that of the view's map, larger by the margins on each side.
struct SurroundingDepth {
    int margin_x = 0;
    int margin_y = 0;
    DepthMap map;  ///< kKnown where another view's confident pixel falls, else kUnseen.
};

/// Carries the confident pixels of its neighbours' maps, and of theirs, into view `view_index`; of
/// those that fall on one pixel the nearest counts, and small gaps are closed. The picture itself
/// is what is known `within` it, of the view's size.
[[nodiscard]] SurroundingDepth surrounding_depth(const DepthScene& scene,
                                                 const std::vector<DepthMap>& maps, int view_index,
                                                 const DepthMap& within);

}  // namespace lumi
