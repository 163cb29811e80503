#include "pipeline/evaluate/metric_words.h"

#include <algorithm>
#include <cassert>
#include <string_view>

#include "pipeline/text/number_text.h"

namespace lumi {

const std::vector<MetricWords>& metric_words() {
    static const std::vector<MetricWords> all{
        {"psnr_db", "PSNR", "dB", 2,
         "error over the full frame, guesses included; more is better: 6 dB more is half of the "
         "error, and from about 30 dB on differences are small"},
        {"psnr_covered_db", "covered", "dB", 2,
         "the same over the pixels that some photograph shows"},
        {"ssim", "SSIM", "", 4, "likeness of structure; 1 is the same"},
        {"flip", "FLIP", "", 4,
         "what the eye notices when picture and photograph are flipped; 0 is nothing, less is "
         "better"},
        {"flip_covered", "FLIP, covered", "", 4, "FLIP over covered pixels"},
        {"edge_sharpness", "sharpness", "", 3,
         "how strong edges are beside the photograph's (gradient energy, covered pixels); 1 is as "
         "sharp, less is blurred"},
        {"psnr_gain_fitted_db", "but for exposure", "dB", 2,
         "covered dB after exposure and white balance were evened out"},
        {"ghost_energy", "ghost energy", "", 2,
         "how far the photographs that are blended disagree (squared levels of luma); 0 is not "
         "at all"},
        {"psnr_subject_db", "subject", "dB", 2,
         "error over the subject's pixels, drawn or not; more is better"},
        {"flip_subject", "FLIP, subject", "", 4, "FLIP over the subject's pixels"},
        {"subject_coverage", "subject covered", "%", 2,
         "how much of the subject some photograph shows"},
        {"coverage", "coverage", "%", 2, "how much of the frame some photograph shows"},
        {"ms", "time", "ms", 1, "of a frame, by the clock, on this machine"},
        {"cpu_ms", "CPU", "ms", 1, "of a frame, over all threads"}};
    return all;
}

const MetricWords& words_of(const ScoreMetric& metric) {
    const auto found = std::find_if(
        metric_words().begin(), metric_words().end(),
        [&](const MetricWords& words) { return std::string_view(words.name) == metric.name; });
    assert(found != metric_words().end());
    return *found;
}

std::string told_range(const ScoreMetric& metric, const Interval& range) {
    const MetricWords& words = words_of(metric);
    const std::string unit = words.unit;
    const double factor = unit == "%" ? 100.0 : 1.0;
    return std::string(words.words) + " " + number_text(factor * range.low, words.decimals) +
           " to " + number_text(factor * range.high, words.decimals) +
           (unit.empty() ? "" : " " + unit);
}

}  // namespace lumi
