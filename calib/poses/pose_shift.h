#pragma once

#include "calib/capture/capture.h"
#include "calib/poses/pose_comparison.h"

namespace lumi {

/// Poses that another model of the same photographs moves farther are not known: three quarters of
/// what a success may be off (a tenth of the cameras' spread, two degrees), because the shift is an
/// estimate itself.
inline constexpr double kMaxShiftShare = 0.075;
inline constexpr double kMaxTurn_deg = 1.5;

/// How far poses are from others of the same photographs.
struct PoseShift {
    int placed = 0;  ///< Photographs that both have.
    /// Of the worst camera, as a share of the cameras' spread: the root mean square distance of the
    /// others' centres from their middle.
    double position_share = 0.0;
    double rotation_deg = 0.0;  ///< Of the worst camera.

    /// True when poses that move so far between two models of the same photographs are not known.
    [[nodiscard]] bool matters() const { return exceeds(1.0); }
    /// The same for limits that are `factor` times as wide.
    [[nodiscard]] bool exceeds(double factor) const {
        return position_share > factor * kMaxShiftShare || rotation_deg > factor * kMaxTurn_deg;
    }
};

/// After the similarity that fits `poses` to `others`: its rotation is the mean of what the
/// cameras' attitudes say (the chordal mean; Hartley et al., Rotation averaging, IJCV 2013), so
/// that it is defined for cameras on a line and for two cameras as well; scale and translation are
/// then least squares over the centres. Cameras that stand at one place have no spread: the share
/// is infinite.
[[nodiscard]] PoseShift pose_shift(const NamedPoses& poses, const NamedPoses& others);

/// The root mean square distance of the centres from their middle; 0 for none.
[[nodiscard]] double spread_of_centres(const NamedPoses& poses);

/// The poses of a capture by the names of its views.
[[nodiscard]] NamedPoses named_poses(const Capture& capture);

}  // namespace lumi
