#pragma once

#include <optional>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/poses/pose_shift.h"
#include "calib/work/progress.h"

namespace lumi {

/// Another way in which two parts of a capture may stand to each other.
struct OtherJoint {
    Capture moved;  ///< With the part there.
    PoseShift shift;
    double cost_ratio = 0.0;  ///< Robust squared residuals of the shared points, over those before.
};

/// How well the points that two parts of a capture share tell how the parts stand to each other:
/// the similarity (7 unknowns) between two rigid parts.
struct PartJoint {
    int points = 0;  ///< Seen from both parts, and looked at.
    /// What one standard deviation of the similarity moves cameras by; infinite where the points do
    /// not determine it.
    PoseShift uncertainty;
    /// A narrow strip of points, nearly in a plane, looks much the same when it is tilted the other
    /// way (Oberkampf, DeMenthon, Davis, Iterative pose estimation using coplanar feature points,
    /// CVIU 1996). Empty where no other attitude is a minimum that matters.
    std::optional<OtherJoint> other;

    /// The other joint explains the points clearly better.
    [[nodiscard]] bool is_elsewhere() const;
    /// Cameras of one part may well stand elsewhere, by more than poses may be wrong. (What is less
    /// uncertain is told by the poses' own covariance.)
    [[nodiscard]] bool is_weak() const;
};

/// Examines the joint between the views with `is_in_part` and the others, by robust least squares.
/// Both parts are held as they are, and points that both see are free. Of very many points some are
/// looked at, evenly. `scale_px` is that of Cauchy's loss (cauchy_scale_px of the whole capture).
/// Throws Error: E-INTERRUPTED.
[[nodiscard]] PartJoint examine_joint(const Capture& capture, const std::vector<char>& is_in_part,
                                      double scale_px, const Progress& progress);

}  // namespace lumi
