#pragma once

#include "calib/capture/capture.h"

namespace lumi {

/// Whether what the adjustment could not explain has a shape that a cause would leave.
///
/// In each view the residuals are regressed on what a small wrong does to them; the ratio is that
/// of the variance taken away, per parameter, to the variance left (Fisher's F over all views): 1
/// on average where there is nothing but noise.
struct ResidualPattern {
    double shutter_ratio = 1.0;  ///< A turn that grows from the first row to the last; 3 a view.
    /// A focal length of the view's own, beside its pose, which makes up for most of one; 1 a view.
    double zoom_ratio = 1.0;

    /// True when each picture seems to have something of its own. With three parameters for each of
    /// ten views noise alone is beyond 2 once in ten thousand captures; lens models that do not fit
    /// quite raise the ratio a little.
    [[nodiscard]] bool is_suspicious() const { return shutter_ratio > 4.0; }
    /// True when each picture seems to have a focal length of its own. Captures of one focus were
    /// seen to reach 3, focal lengths that differ by 1 % at random 900; what a rolling shutter does
    /// looks a little like it, too.
    [[nodiscard]] bool is_zoomed() const { return zoom_ratio > 4.0 && zoom_ratio > shutter_ratio; }
};
[[nodiscard]] ResidualPattern residual_pattern(const Capture& capture);

/// The Bayesian information criterion's verdict (Schwarz 1978): true when the smaller cost is worth
/// `more_parameters`.
[[nodiscard]] bool explains_better(double cost_px2, double richer_cost_px2, int more_parameters,
                                   std::size_t observations);

}  // namespace lumi
