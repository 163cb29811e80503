#pragma once

#include <Eigen/Core>

#include "render/lumigraph/lumigraph.h"
#include "render/transfer/pixel_transfer.h"

namespace lumi {

/// A view, as it is asked whether it looks past points on the rays of one eye.
class PastSight {
 public:
    /// The view must have depth, and stay.
    PastSight(const LumigraphView& view, const Eye& eye);

    /// Whether the view's depth map has, where the point at `inverse_depth` on the eye's ray
    /// through `pixel` lies in it, something behind that point, by more than `least_difference` as
    /// inverse depth of the eye. Not where something nearer hides the point, nor outside of the
    /// photograph.
    [[nodiscard]] bool is_past(const Eigen::Vector2d& pixel, double inverse_depth,
                               double least_difference) const;

    /// From the eye's pixels to samples of the depth map.
    [[nodiscard]] const PixelTransfer& samples_from_eye() const { return samples_from_eye_; }

 private:
    PixelTransfer samples_from_eye_;
    const FloatImage* inverse_depth_;
};

}  // namespace lumi
