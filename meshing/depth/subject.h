#pragma once

#include <vector>

#include "meshing/agreement/visual_hull.h"
#include "meshing/depth_scene/depth_estimate.h"
#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// What masks (view_mask.h) leave of a scene, while its depth is found: nothing is known of the
/// rest, until all of it is known to be behind.
class Subject {
 public:
    /// `masks`: one a view. Both must outlive the subject.
    Subject(const DepthScene& scene, const std::vector<GrayImage>& masks);

    /// Takes back what an estimate claims beyond the view's mask; and, unless the claim is final,
    /// outside of the visual hull.
    void leave_claims_within(int view_index, DepthEstimate& estimate) const;

    /// Of a filled map: what was filled is moved inside the visual hull, unless the estimate was
    /// complete, and the background is separated. Returns the background's share.
    double separate_from_background(int view_index, const DepthEstimate& estimate,
                                    DepthMap& map) const;

    [[nodiscard]] const std::vector<GrayImage>& masks() const { return masks_; }

 private:
    const std::vector<GrayImage>& masks_;
    VisualHull hull_;
};

}  // namespace lumi
