#pragma once

#include <vector>

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// What the outlines of a subject say of its depth: no point of it is where views see the known
/// background, which `masks` (view_mask.h) leave out. What they leave is the visual hull
/// (Laurentini 1994).
///
/// A view is against a point where it has nothing but background within a pixel of it, as cameras
/// are placed and masks drawn to about one. Two have to be, as one mask may be wrong. Asked are a
/// view's neighbours, theirs, and others evenly over the capture, 32 at most. A view without a mask
/// is never asked, and nothing is changed in it.
class VisualHull {
 public:
    /// `masks`: one a view. Both must outlive the hull.
    VisualHull(const DepthScene& scene, const std::vector<GrayImage>& masks);

    /// Takes the claim to know a depth from pixels of view `view_index` whose points are outside.
    void take_claims_outside(int view_index, DepthMap& map) const;

    /// What belongs to the scene, is not known, and would be outside as it was filled, gets the
    /// nearest inverse depth in the view's range, in steps of a pixel of disparity (or of a 4096th
    /// of the range, if that is more), at which it is not; or stays, where there is none.
    void move_fills_inside(int view_index, DepthMap& map) const;

 private:
    /// Of the pixels of one view.
    class Rays;

    const DepthScene& scene_;
    const std::vector<GrayImage>& masks_;
};

}  // namespace lumi
