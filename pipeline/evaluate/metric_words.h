#pragma once

#include <string>
#include <vector>

#include "pipeline/evaluate/bootstrap.h"
#include "pipeline/evaluate/view_score.h"

namespace lumi {

/// How people are told a figure of a score.
struct MetricWords {
    const char* name;   ///< As ScoreMetric::name.
    const char* words;  ///< What stands in tables and lines: "PSNR".
    const char* unit;   ///< "dB"; "%", of what is a share; "" for none.
    int decimals;
    const char* meaning;  ///< What it is, what is good, and how good is good.
};

/// Of every metric, in the order of score_metrics().
[[nodiscard]] const std::vector<MetricWords>& metric_words();
[[nodiscard]] const MetricWords& words_of(const ScoreMetric& metric);

/// "PSNR 22.63 to 28.43 dB".
[[nodiscard]] std::string told_range(const ScoreMetric& metric, const Interval& range);

}  // namespace lumi
