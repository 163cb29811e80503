#pragma once

#include <cstddef>

#include "calib/capture/capture.h"
#include "calib/work/progress.h"

namespace lumi {

/// What may be true of photographs that one lens in cameras that stood still does not explain.
enum class Supposition {
    kSteady,   ///< Nothing: the lens is the same, and all rows were taken at one moment.
    kZoomed,   ///< Each picture has a scale of its own, as where the focus moves.
    kTurning,  ///< The camera turned evenly while the rows were read out, from top to bottom.
    /// Each picture has a principal point and a scale of its own: it was cropped or straightened,
    /// or the lens was moved by its stabiliser or its focus.
    kShifted,
};

/// What is adjusted of the lenses that views share, whatever is supposed of the views.
enum class SupposedLens {
    kHeld,        ///< Nothing: it is calibrated.
    kMiddleHeld,  ///< Focal length, and radial distortion besides that of the lens.
    kFree,        ///< These, and the principal point.
};

/// A capture adjusted under a supposition.
struct SupposedAdjustment {
    /// Poses at the middle row; lenses as they came, through which a picture that was cut elsewhere
    /// is that of a camera that is turned.
    Capture capture;
    double cost_px2 = 0.0;  ///< Sum of squared residuals, each truncated at the limit.
    /// What the supposition does to pictures, root mean square over them: how far the last row is
    /// turned away from the first, or how far the lens's middle lies from where it was taken to be.
    double effect_px = 0.0;
    /// How far the lens's middle lies from there in the mean of all pictures.
    double common_px = 0.0;
    int parameters = 0;            ///< More than steady has.
    std::size_t observations = 0;  ///< That were looked at.

    /// True when the lens's middle lies elsewhere in all pictures alike more than in each.
    [[nodiscard]] bool is_mostly_common() const {
        return 2 * common_px * common_px > effect_px * effect_px;
    }
};

/// Adjusts poses, points, lenses (as far as `lenses` says) and up to three parameters of each
/// view's own by robust least squares, over a few hundred points a photograph, those with the
/// longest tracks: a turning rate (Hedborg et al., Rolling shutter bundle adjustment, CVPR 2012,
/// for rotation alone, which moves pictures most), or a principal point and a scale. A weak prior
/// holds those that nothing determines; turns that have something in common, in the axes of the
/// cameras or of the world, are not found: bent points and poses, and lenses, do the same (Albl,
/// Sugimoto, Pajdla, Degeneracies in rolling shutter SfM, ECCV 2016), and hands differ from picture
/// to picture. Adjustments from one start look at the same observations, so that their costs can be
/// compared. Throws Error: E-INTERRUPTED.
[[nodiscard]] SupposedAdjustment adjust_supposing(Supposition supposition, const Capture& capture,
                                                  SupposedLens lenses, double limit_px,
                                                  const Progress& progress);

/// Whether a scale of each picture's own explains more than the lens that they share, by the
/// information criterion; each point counts once, as errors within a track go together. A principal
/// point off the middle of all pictures looks like focal lengths that run along the path, and these
/// like it: unless `lenses_are_held`, it is free where no picture has a scale of its own, and held
/// or free where they do, whichever comes to less. Throws Error: E-INTERRUPTED.
[[nodiscard]] bool own_scales_explain_better(const Capture& capture, bool lenses_are_held,
                                             double limit_px, const Progress& progress);

}  // namespace lumi
