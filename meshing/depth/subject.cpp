#include "meshing/depth/subject.h"

#include "meshing/depth_scene/view_mask.h"

namespace lumi {

Subject::Subject(const DepthScene& scene, const std::vector<GrayImage>& masks)
    : masks_(masks), hull_(scene, masks) {}

void Subject::leave_claims_within(int view_index, DepthEstimate& estimate) const {
    claim_nothing_beyond(masks_[static_cast<std::size_t>(view_index)], estimate.map);
    if (estimate.needs_confirmation) hull_.take_claims_outside(view_index, estimate.map);
}

double Subject::separate_from_background(int view_index, const DepthEstimate& estimate,
                                         DepthMap& map) const {
    if (!estimate.is_complete) hull_.move_fills_inside(view_index, map);
    return separate_background(masks_[static_cast<std::size_t>(view_index)], map);
}

}  // namespace lumi
