#pragma once

#include <string>
#include <vector>

namespace lumi {

/// What makes depth hard to find.
enum class DepthHazard {
    kTexture,
    kNoise,
    kPoses,
    kBaseline,
    kGloss,
    kExposure,
    kThin,
    kSteps,
    kFocalLength
};

/// A hazard, and how strong it is made.
struct DepthHazardCurve {
    DepthHazard hazard;
    std::string name;               ///< As on the command line: "texture".
    std::string title;              ///< Of its chart.
    std::string strength;           ///< What the numbers mean.
    std::vector<double> strengths;  ///< From harmless to hopeless; above 0.
};

[[nodiscard]] const std::vector<DepthHazardCurve>& depth_hazard_curves();
[[nodiscard]] const DepthHazardCurve& curve_of(DepthHazard hazard);

}  // namespace lumi
