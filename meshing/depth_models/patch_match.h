#pragma once

#include <vector>

#include "meshing/depth_models/depth_model.h"
#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

struct PatchMatchOptions {
    int iterations = 3;  ///< Sweeps over the picture, to and fro in turn.
    /// Cost of one pixel by which a neighbour's own depth disagrees beyond the first half, where 1
    /// is no correlation.
    float disagreement_per_px = 0.1F;
    /// Pixels that two neighbours' estimates confirm keep their plane where it fits as well as it
    /// does there on the whole: costs less than three times the median, within 0.05 and 0.25.
    bool only_where_unsure = false;
};

/// Depth of one view refined by slanted windows: PatchMatch stereo (Bleyer et al. 2011) for several
/// views, with geometric consistency (Schoenberger et al. 2016, section 4.3; Xu and Tao 2019).
///
/// Each pixel begins with the plane through the estimate's surface there, and takes over a
/// neighbouring pixel's plane, or a small change of its own, when that fits the two best views
/// better. In the cost stands also by how many pixels those views' own estimates disagree, up to 3.
/// The same on every run: the changes come from a hash of pixel and iteration.
///
/// Confidence is kKnown where the windows correlate. Where they do not, the estimate and its claim
/// to know stand, if the windows of most claimed pixels do; it is kUnseen elsewhere. Whether views
/// agree is not asked here. A window of seven pixels tells less of a shaded cheek, or of a
/// highlight, than a wider matching did: to deny that would leave a hole, filled with the
/// background. Only noise correlates nowhere.
[[nodiscard]] DepthMap patch_match(const DepthScene& scene,
                                   const std::vector<DepthEstimate>& estimates, int view_index,
                                   const PatchMatchOptions& options = {});

}  // namespace lumi
