#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/depth_bench/depth_hazard.h"

namespace lumi {

/// What one depth model made of a capture under a hazard.
struct RungStability {
    std::string model;
    /// Share of the asked pixels with texture that some neighbour sees, whose depth is within one
    /// pixel of the true disparity in the fastest-moving neighbour (right_shares.h).
    double right_share = 0.0;
    double claimed_share = 0.0;        ///< Of all pixels: those with confidence.
    double claimed_right_share = 0.0;  ///< Of the asked ones among these: within one pixel.
    double cpu_s = 0.0;
    bool is_warned = false;  ///< Depth itself said that it is doubtful (DepthResult::warning).
};

struct StabilityTrial {
    DepthHazard hazard = DepthHazard::kTexture;
    double strength = 0.0;
    std::uint64_t seed = 0;
    std::vector<RungStability> rungs;
};

/// Photographs the scene into a folder beside `scratch_of`, which goes at the end, and asks
/// `models` (depth_model_names()). Throws Error like estimate_depth.
[[nodiscard]] StabilityTrial stability_trial(DepthHazard hazard, double strength,
                                             std::uint64_t seed,
                                             const std::vector<std::string>& models,
                                             const std::filesystem::path& scratch_of, int threads,
                                             Progress& progress);

/// True when a model claims a tenth of the picture or more, is wrong in more than a fifth of what
/// it claims, and gives no warning: nobody who looks at its confidence would know.
[[nodiscard]] bool claims_too_much(const RungStability& rung);

/// The strength at which a model's right share, mean over the seeds, first lies a tenth below that
/// at the most harmless strength tried; empty while none does.
[[nodiscard]] std::optional<double> breaking_strength(const std::vector<StabilityTrial>& trials,
                                                      DepthHazard hazard, const std::string& model);

/// Mean right share over the seeds; empty where nothing was tried.
[[nodiscard]] std::optional<double> mean_right_share(const std::vector<StabilityTrial>& trials,
                                                     DepthHazard hazard, double strength,
                                                     const std::string& model);

}  // namespace lumi
