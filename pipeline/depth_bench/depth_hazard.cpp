#include "pipeline/depth_bench/depth_hazard.h"

#include <algorithm>

namespace lumi {

const std::vector<DepthHazardCurve>& depth_hazard_curves() {
    static const std::vector<DepthHazardCurve> curves{
        {DepthHazard::kTexture,
         "texture",
         "Texture fades",
         "contrast of all surfaces, share of the full one",
         {1, 0.3, 0.1, 0.03, 0.01}},
        {DepthHazard::kNoise,
         "noise",
         "The sensor is noisy",
         "standard deviation of the noise, 8-bit levels",
         {1, 3, 9, 20, 45}},
        {DepthHazard::kPoses,
         "poses",
         "Cameras are not where they are said to be",
         "standard deviation of turn and of place, each px in the picture",
         {0.05, 0.25, 0.5, 1, 2.5}},
        {DepthHazard::kBaseline,
         "baseline",
         "Cameras stand far apart",
         "distance to the middle camera, share of the scene's",
         {0.04, 0.08, 0.16, 0.32, 0.64}},
        {DepthHazard::kGloss,
         "gloss",
         "Surfaces shine",
         "strength of highlights",
         {0.03, 0.3, 1, 3, 9}},
        {DepthHazard::kExposure,
         "exposure",
         "Exposure drifts from photograph to photograph",
         "largest error of a photograph's exposure, stops",
         {0.03, 0.25, 0.5, 1, 2.5}},
        {DepthHazard::kThin,
         "thin",
         "Thin bars before a wall: pixels of the bars",
         "width of a bar, px",
         {16, 8, 4, 2, 1}},
        {DepthHazard::kSteps,
         "steps",
         "Steps of depth: pixels within 4 px of an edge",
         "height of the step, px of disparity",
         {2, 4, 8, 16, 32}},
        {DepthHazard::kFocalLength,
         "focal-length",
         "The focal length is wrong",
         "error of the focal length, percent",
         {0.05, 0.5, 1, 2.5, 6}}};
    return curves;
}

const DepthHazardCurve& curve_of(DepthHazard hazard) {
    const auto& curves = depth_hazard_curves();
    return *std::find_if(curves.begin(), curves.end(),
                         [&](const DepthHazardCurve& curve) { return curve.hazard == hazard; });
}

}  // namespace lumi
