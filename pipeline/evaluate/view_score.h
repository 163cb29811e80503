#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/evaluate/bootstrap.h"
#include "pipeline/evaluate/view_place.h"

namespace lumi {

/// How close a rendering comes to the photograph that was held out.
struct ViewScore {
    std::string name;
    double psnr_db = 0.0;                        ///< Over the full frame.
    std::optional<double> psnr_covered_db = {};  ///< Over covered pixels; empty when none is.
    double ssim = 0.0;
    double coverage = 0.0;  ///< Share of pixels drawn, 0 to 1.
    double ms = 0.0;        ///< Median over repeated frames, one warm-up frame aside.
    double cpu_ms = 0.0;    ///< The same of the process's CPU time over all threads.
    double flip = 0.0;      ///< Mean FLIP over the full frame, 0 (equal) to 1.
    std::optional<double> flip_covered = {};
    std::optional<double> edge_sharpness = {};  ///< Gradient energy over the photograph's, covered.
    /// Covered PSNR after a gain and bias per channel: without exposure and white balance.
    std::optional<double> psnr_gain_fitted_db = {};
    std::array<double, 3> gain{1.0, 1.0, 1.0};  ///< Of that fit.
    std::optional<double> ghost_energy = {};    ///< Mean over the frame; squared 8-bit luma.
    /// Over the subject's pixels, drawn or not; empty without a mask of the photograph.
    std::optional<double> psnr_subject_db = {};
    std::optional<double> flip_subject = {};
    std::optional<double> subject_coverage = {};  ///< Share of the subject's pixels drawn, 0 to 1.
    std::optional<double> subject_share = {};     ///< The subject's share of the frame, 0 to 1.
    ViewPlace place = ViewPlace::kInterior;
    double fastest_ms = 0.0;  ///< Of the repeated frames.
    double slowest_ms = 0.0;
    int width_px = 0;  ///< Of the photograph and the rendering; 0 in evaluations of early versions.
    int height_px = 0;
    /// Which photograph it is, by its working copy, however that was straightened; "" where that is
    /// not known.
    std::string photograph_sha256 = {};

    friend bool operator==(const ViewScore&, const ViewScore&) = default;
};

/// The dB over covered pixels but for exposure and white balance, where that makes a difference of
/// a decibel and more: what a low figure is then due to.
[[nodiscard]] std::optional<double> psnr_but_for_exposure_db(
    const std::optional<double>& psnr_covered_db, const std::optional<double>& psnr_gain_fitted_db);

/// A figure of a view's score, by the name it has in JSON.
struct ScoreMetric {
    const char* name;
    std::optional<double> (*value)(const ViewScore& score);
    /// No value is 0 for a figure that no view may lack.
    void (*set)(ViewScore& score, std::optional<double> value);
    bool may_lack;  ///< Whether a view may be without it.
    bool higher_is_better;
    bool is_time = false;  ///< Differs from run to run, by what else the machine does.
};

/// All figures that are averaged over views, in the order in which they are told.
[[nodiscard]] const std::vector<ScoreMetric>& score_metrics();

/// The figure over the views that have it.
[[nodiscard]] std::vector<double> values_of(const ScoreMetric& metric,
                                            const std::vector<ViewScore>& views);
[[nodiscard]] std::optional<double> mean_of(const ScoreMetric& metric,
                                            const std::vector<ViewScore>& views);
[[nodiscard]] std::optional<Interval> interval_of(const ScoreMetric& metric,
                                                  const std::vector<ViewScore>& views);

/// From the view where it is least to the one where it is greatest.
[[nodiscard]] std::optional<Interval> range_of(const ScoreMetric& metric,
                                               const std::vector<ViewScore>& views);

/// The mean over views; for what not every view has, over those that have it. `name` is "mean".
[[nodiscard]] ViewScore mean_score(const std::vector<ViewScore>& views);

/// The views that stand there.
[[nodiscard]] std::vector<ViewScore> views_at(ViewPlace place, const std::vector<ViewScore>& views);

}  // namespace lumi
