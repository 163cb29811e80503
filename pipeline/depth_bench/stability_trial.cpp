#include "pipeline/depth_bench/stability_trial.h"

#include "calib/capture/all_views.h"
#include "calib/work/whole_folder.h"
#include "meshing/depth/depth_stage.h"
#include "meshing/depth_scene/depth_scene.h"
#include "pipeline/depth_bench/right_shares.h"
#include "pipeline/depth_bench/stability_capture.h"

namespace lumi {
namespace {

RungStability measured(const StabilityCapture& capture, const DepthScene& harmless,
                       const DepthOptions& options, int threads, Progress& progress) {
    const DepthResult found =
        estimate_depth(capture.told, all_views(capture.told.capture), options, threads, progress);
    const RightShares shares = right_shares(harmless, capture.truth, found.depth_maps);
    RungStability rung{options.model,       shares.of_visible,  0,
                       shares.of_confident, found.choice_cpu_s, !found.warning.empty()};
    for (const DepthEvidence& evidence : found.evidence) {
        rung.claimed_share += evidence.confident_share / static_cast<double>(found.evidence.size());
        rung.cpu_s += evidence.cpu_s;
    }
    return rung;
}

}  // namespace

StabilityTrial stability_trial(DepthHazard hazard, double strength, std::uint64_t seed,
                               const std::vector<std::string>& models,
                               const std::filesystem::path& scratch_of, int threads,
                               Progress& progress) {
    const WholeFolder scratch(scratch_of);
    const StabilityCapture capture =
        stability_capture(hazard, strength, seed, scratch.staging(), threads, progress);
    DepthOptions options;
    options.background = "keep";
    const DepthScene harmless = make_depth_scene(
        capture.harmless, all_views(capture.harmless.capture),
        {.max_width_px = options.max_width_px, .max_neighbours = options.max_neighbours}, threads,
        progress);
    StabilityTrial trial{hazard, strength, seed, {}};
    for (const std::string& model : models) {
        options.model = model;
        trial.rungs.push_back(measured(capture, harmless, options, threads, progress));
    }
    return trial;
}

bool claims_too_much(const RungStability& rung) {
    constexpr double kLeastClaim = 0.1;
    constexpr double kMostWrong = 0.2;
    return !rung.is_warned && rung.claimed_share >= kLeastClaim &&
           rung.claimed_right_share < 1 - kMostWrong;
}

std::optional<double> mean_right_share(const std::vector<StabilityTrial>& trials,
                                       DepthHazard hazard, double strength,
                                       const std::string& model) {
    double sum = 0;
    int count = 0;
    for (const StabilityTrial& trial : trials) {
        if (trial.hazard != hazard || trial.strength != strength) continue;
        for (const RungStability& rung : trial.rungs) {
            if (rung.model != model) continue;
            sum += rung.right_share;
            ++count;
        }
    }
    return count == 0 ? std::nullopt : std::optional(sum / count);
}

std::optional<double> breaking_strength(const std::vector<StabilityTrial>& trials,
                                        DepthHazard hazard, const std::string& model) {
    constexpr double kFall = 0.1;
    std::optional<double> first;
    for (const double strength : curve_of(hazard).strengths) {
        const auto share = mean_right_share(trials, hazard, strength, model);
        if (!share) continue;
        if (!first) first = share;
        if (*share < *first - kFall) return strength;
    }
    return std::nullopt;
}

}  // namespace lumi
