#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "calib/doctor/capture_reason.h"

namespace lumi {

/// A way in which photographs can be unfit for poses, from harmless to hopeless.
enum class Hazard {
    kBaseline,    ///< The step between photographs shrinks against the distance.
    kRotation,    ///< The camera turns, and moves less and less meanwhile.
    kPlanarity,   ///< What stands out of a wall shrinks.
    kTexture,     ///< Contrast fades.
    kNoise,       ///< Sensor noise grows.
    kBlur,        ///< Out of focus.
    kShutter,     ///< The camera moves while the rows are read out.
    kExposure,    ///< Exposure jumps from photograph to photograph.
    kClutter,     ///< A growing share shows things that do not stand still.
    kOverlap,     ///< Two halves share less and less.
    kRepetition,  ///< A box with four equal sides, told apart by one mark that shrinks.
    kSteps,       ///< Such a box without a mark, walked around in wider and wider steps.
    kFocalPrior,  ///< EXIF tells a wrong focal length.
    kZoom,        ///< Every other photograph is zoomed, and nothing tells.
    kFocus,       ///< Focal lengths differ from photograph to photograph, as where the focus moves.
    kDuplicates,  ///< Fewer and fewer places, photographed again and again.
    kForward,     ///< The camera walks towards the scene, ever straighter.
    kFisheye,     ///< The lens sees more and more, and nothing tells that it bends what it sees.
};

/// How a hazard is driven through its breaking point.
struct HazardCurve {
    Hazard hazard = Hazard::kBaseline;
    std::string name;               ///< For files and the command line.
    std::string strength;           ///< What the strengths measure, with its unit.
    CaptureReason reason;           ///< What a photographer should be told.
    std::vector<double> strengths;  ///< From harmless to hopeless.
};

/// All hazards; the first strength of each harms nobody.
[[nodiscard]] const std::vector<HazardCurve>& hazard_curves();
[[nodiscard]] const HazardCurve& curve_of(Hazard hazard);

}  // namespace lumi
