#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/ingest/ingest.h"
#include "pipeline/chart/sweep.h"
#include "pipeline/evaluate/evaluation.h"

namespace lumi {

/// What a stage took, once for each time that it was run.
struct StageTimes {
    std::string stage;
    std::vector<double> cpu_s;
    std::vector<double> wall_s;
};

/// A variant as it was built and measured.
struct MeasuredVariant {
    std::string failure;  ///< failure_text; empty when it was built.
    std::vector<StageTimes> stages;
    double package_mib = 0.0;
    bool repeats_are_equal = true;   ///< The package, to the last bit, in every repetition.
    std::vector<ModeScores> scores;  ///< Over `ChartResult::shared_views`, one per mode.
};

/// Work of a sweep, in CPU seconds; its repetitions aside.
struct SweepWork {
    double done_cpu_s = 0.0;   ///< In this run.
    double alone_cpu_s = 0.0;  ///< Had every point been made and measured by itself.

    /// Of the work, 0 to 1, that came from the cache.
    [[nodiscard]] double cached_share() const {
        return alone_cpu_s > 0.0 ? 1.0 - done_cpu_s / alone_cpu_s : 0.0;
    }
};

/// What was found out about a sweep.
struct ChartResult {
    Sweep sweep;
    std::vector<MeasuredVariant> variants;  ///< One for each variant of the sweep.
    std::vector<std::string> shared_views;  ///< Held out and placed in every variant.
    /// The working copies that all are compared with: of the variant with most pixels.
    std::vector<Photograph> reference_copies;
    int reference_width_px = 0;  ///< Of these.
    std::string gl_description;
    SweepWork work;
    double wall_s = 0.0;
};

/// One package drawn in one mode.
struct ChartPoint {
    std::size_t variant = 0;
    RenderMode mode = RenderMode::kPerPixel;
    std::string label;  ///< Variant and mode.
    double build_cpu_s = 0.0;
    double build_wall_s = 0.0;
    double package_mib = 0.0;
    double frame_ms = 0.0;
    ViewScore mean;
    std::optional<Interval> flip_interval;
    std::optional<Interval> psnr_interval;
};

/// All points of variants that were built, in the order of the variants.
[[nodiscard]] std::vector<ChartPoint> points_of(const ChartResult& result);

/// CPU or wall seconds of all stages of a variant, each the median of its repetitions.
[[nodiscard]] double build_cpu_s(const MeasuredVariant& variant);
[[nodiscard]] double build_wall_s(const MeasuredVariant& variant);

}  // namespace lumi
