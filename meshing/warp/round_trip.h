#pragma once

#include <Eigen/Core>
#include <optional>

#include "calib/capture/inverse_depth_warp.h"

namespace lumi {

/// A pixel of a view that was sent to another one and back.
struct ReturnedPixel {
    double error_px;       ///< The forward-backward error: how far from where it set out.
    double inverse_depth;  ///< Of the other's surface, as the view itself would see it.
};

/// From a view to another and back by what that one knows: where both see one surface a pixel comes
/// back to where it set out (the left-right consistency check; Hirschmueller, PAMI 2008).
struct RoundTrip {
    InverseDepthWarp there;
    InverseDepthWarp back;

    /// `pixel` of the view, which lies at `pixel_there` of the other, by the inverse depth that the
    /// other has there. Empty where that is not in front of the view.
    [[nodiscard]] std::optional<ReturnedPixel> returned(const Eigen::Vector2d& pixel,
                                                        const Eigen::Vector2d& pixel_there,
                                                        double inverse_depth_there) const {
        const auto at = back.at(pixel_there, inverse_depth_there);
        if (!at) return std::nullopt;
        return ReturnedPixel{(at->pixel - pixel).norm(), at->inverse_depth};
    }
};

[[nodiscard]] inline RoundTrip round_trip(const PosedCamera& view, const PosedCamera& other) {
    return {warp_from(view).to(other), warp_from(other).to(view)};
}

}  // namespace lumi
