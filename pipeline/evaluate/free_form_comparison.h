#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/evaluate/evaluation.h"

namespace lumi {

/// One of lumi's modes beside the same mode of pictures that a regular parameterisation asks for:
/// what the paper measures free-form light fields by. Both are drawn by the same code, which
/// projects into three views in either case, so that the ratio tells what other pictures and
/// triangles cost, not what a renderer would save that knows its cameras' plane.
struct FreeFormBesideResampled {
    RenderMode mode = RenderMode::kLightField;
    std::string resampled;            ///< RivalScores::method, such as "two-plane adaptive".
    std::optional<double> cpu_ratio;  ///< Of a mean frame; empty where no time was measured.
    double psnr_gain_db = 0.0;        ///< Free-form less resampled, means over full frames.
    std::optional<double> common_psnr_gain_db;  ///< The same over common pixels.
};

/// Of every resampled method whose mode was judged, too, in the order of the methods.
[[nodiscard]] std::vector<FreeFormBesideResampled> free_form_beside_resampled(
    const Evaluation& evaluation);

}  // namespace lumi
