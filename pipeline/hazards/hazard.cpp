#include "pipeline/hazards/hazard.h"

#include <algorithm>

namespace lumi {

const std::vector<HazardCurve>& hazard_curves() {
    using Reason = CaptureReason;
    static const std::vector<HazardCurve> kCurves{
        {Hazard::kBaseline,
         "baseline",
         "step / distance",
         Reason::kNoParallax,
         {0.12, 0.04, 0.012, 0.003, 0.0005}},
        {Hazard::kRotation,
         "rotation",
         "way / distance",
         Reason::kNoParallax,
         {0.6, 0.15, 0.04, 0.01, 0.0}},
        {Hazard::kPlanarity,
         "planarity",
         "relief / distance",
         Reason::kPlanar,
         {0.15, 0.05, 0.015, 0.004, 0.0}},
        {Hazard::kTexture, "texture", "contrast", Reason::kTexture, {1.0, 0.3, 0.1, 0.03, 0.01}},
        {Hazard::kNoise,
         "noise",
         "standard deviation, grey levels",
         Reason::kNoise,
         {1, 8, 20, 45, 90}},
        {Hazard::kBlur, "blur", "standard deviation, pixels", Reason::kBlur, {0.0, 1, 2.5, 5, 12}},
        {Hazard::kShutter,
         "shutter",
         "skew over the frame, pixels",
         Reason::kShutter,
         {0.0, 1.5, 5, 15, 40}},
        {Hazard::kExposure,
         "exposure",
         "largest error, stops",
         Reason::kExposure,
         {0.3, 1.5, 3, 5, 8}},
        {Hazard::kClutter,
         "clutter",
         "share of the frame",
         Reason::kClutter,
         {0.0, 0.3, 0.6, 0.85, 0.97}},
        {Hazard::kOverlap,
         "overlap",
         "shared by the halves",
         Reason::kSplit,
         {0.6, 0.3, 0.15, 0.05, 0.0}},
        {Hazard::kRepetition,
         "repetition",
         "width of the mark / side",
         Reason::kRepeated,
         {2.0, 0.7, 0.35, 0.15, 0.0}},
        {Hazard::kSteps, "steps", "degrees", Reason::kRepeated, {9, 12, 15, 18, 22.5}},
        {Hazard::kFocalPrior,
         "focal-prior",
         "told / true",
         Reason::kFocal,
         {1.0, 1.15, 1.5, 2.5, 4.0}},
        {Hazard::kZoom,
         "zoom",
         "longer / shorter focal length",
         Reason::kZoom,
         {1.0, 1.03, 1.1, 1.3, 2.0}},
        {Hazard::kFocus,
         "focus",
         "focal lengths differ by up to, %",
         Reason::kZoom,
         {0.0, 0.5, 1.0, 3.0, 8.0}},
        {Hazard::kDuplicates, "duplicates", "places", Reason::kDuplicates, {8, 5, 3, 2, 1}},
        {Hazard::kForward,
         "forward",
         "sideways / forward",
         Reason::kForward,
         {1.0, 0.3, 0.1, 0.03, 0.0}},
        {Hazard::kFisheye,
         "fisheye",
         "corner from the axis, degrees",
         Reason::kFocal,
         {30, 45, 60, 75, 88}},
    };
    return kCurves;
}

const HazardCurve& curve_of(Hazard hazard) {
    return *std::find_if(hazard_curves().begin(), hazard_curves().end(),
                         [&](const HazardCurve& curve) { return curve.hazard == hazard; });
}

}  // namespace lumi
