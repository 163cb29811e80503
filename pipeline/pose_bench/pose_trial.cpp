#include "pipeline/pose_bench/pose_trial.h"

#include <algorithm>
#include <random>

#include "calib/features/nearest_descriptors.h"
#include "calib/poses/colmap_reconstruction.h"
#include "calib/work/error.h"
#include "calib/work/whole_folder.h"

namespace lumi {
namespace {

/// Poses and points, whoever found them.
PoseResult poses_by(const PoseTrialSetting& setting, const PoseMeans& means,
                    const std::vector<Photograph>& photographs,
                    const std::filesystem::path& scratch, Progress& progress) {
    if (means.is_colmap_alone) {
        PoseResult result;
        result.capture = reconstruct_with_colmap(photographs, setting.given_lens, setting.options,
                                                 scratch, setting.threads, progress)
                             .capture.value_or(Capture{});
        return result;
    }
    PoseOptions options = setting.options;
    options.front_end = means.front_end;
    options.mapper = means.mapper;
    options.max_features = means.max_features;
    options.lens_model = means.lens_model;
    return estimate_poses(photographs, setting.given_lens, options, scratch, setting.threads,
                          progress);
}

NamedPoses poses_of(const Capture& capture) {
    NamedPoses poses;
    for (const View& view : capture.views) poses[view.name] = view.cam_from_world;
    return poses;
}

std::vector<Descriptor> random_descriptors(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Descriptor> descriptors(static_cast<std::size_t>(count));
    for (Descriptor& descriptor : descriptors) {
        for (std::uint8_t& value : descriptor) value = static_cast<std::uint8_t>(random() % 70);
    }
    return descriptors;
}

}  // namespace

std::string name_of(const PoseMeans& means) {
    if (means.is_colmap_alone) return "COLMAP alone";
    return std::string(name_of(means.front_end)) + " front end, " +
           std::string(name_of(means.mapper)) + " mapper";
}

PoseTrial try_poses(const PoseTrialSetting& setting, const PoseMeans& means, Progress& progress) {
    IngestOptions ingest_options = setting.ingest;
    ingest_options.max_width_px = means.max_width_px;
    const WholeFolder scratch(setting.scratch_folder / "trial");
    const std::vector<Photograph> photographs =
        ingest(setting.photographs, ingest_options, scratch.staging() / "copies", setting.threads,
               progress)
            .photographs;
    PoseTrial trial;
    trial.means = means;
    trial.photographs = static_cast<int>(photographs.size());
    const Stopwatch stopwatch;
    try {
        const PoseResult result =
            poses_by(setting, means, photographs, scratch.staging() / "poses", progress);
        const Capture& capture = result.capture;
        trial.cost = stopwatch.elapsed();
        trial.placed = static_cast<int>(capture.views.size());
        trial.points = static_cast<int>(capture.points.size());
        if (!capture.views.empty()) {
            trial.focal_px = focal_length_px(camera_of(capture, capture.views.front())).mean();
        }
        if (!result.evidence.lenses.empty()) {
            trial.lens = text_of(result.evidence.lenses.front().form);
        }
        constexpr int kNeededToCompare = 3;
        if (!setting.truth.empty() && trial.placed >= kNeededToCompare) {
            trial.difference = compare_poses(poses_of(capture), setting.truth);
        }
    } catch (const Error& error) {
        const bool took_too_long = error.code() == "E-COLMAP-TIME";
        if (error.kind() != ErrorKind::kDegenerateCapture && !took_too_long) throw;
        trial.cost = stopwatch.elapsed();
        trial.refusal = error.code();
    }
    return trial;
}

std::vector<MatchingCost> time_matching(int features, const Progress& progress) {
    constexpr int kRuns = 5;
    const std::vector<Descriptor> first = random_descriptors(features, 1);
    const std::vector<Descriptor> second = random_descriptors(features, 2);
    std::vector<MatchingCost> costs;
    for (const DescriptorInstructions instructions : descriptor_instructions_here()) {
        MatchingCost cost{std::string(name_of(instructions)), 0};
        for (int run = 0; run < kRuns; ++run) {
            progress.throw_if_interrupted();
            const Stopwatch stopwatch;
            const NearestBothWays nearest = nearest_descriptors(first, second, instructions);
            const double cpu_s = stopwatch.elapsed().cpu_s;
            if (nearest.of_first.empty()) continue;
            cost.cpu_s = run == 0 ? cpu_s : std::min(cost.cpu_s, cpu_s);
        }
        costs.push_back(std::move(cost));
    }
    return costs;
}

}  // namespace lumi
