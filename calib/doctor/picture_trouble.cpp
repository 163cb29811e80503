#include "calib/doctor/picture_trouble.h"

#include <utility>
#include <vector>

#include "calib/work/formatted.h"
#include "calib/work/median.h"

namespace lumi {

std::optional<CaptureReason> trouble_with(const PhotographQuality& quality) {
    constexpr double kMaxClipped = 0.5;
    constexpr double kMinSignalToNoise = 10.0;   // At the best scale; features are finer.
    constexpr double kMinContrast = 2.0;         // Grey levels; features need as much.
    constexpr double kMaxBlurShare = 1.0 / 160;  // Of the longer side.
    if (quality.clipped_share > kMaxClipped) return CaptureReason::kExposure;
    if (quality.noise_sigma > 4 && quality.signal_to_noise < kMinSignalToNoise) {
        return CaptureReason::kNoise;
    }
    if (quality.contrast() < kMinContrast) return CaptureReason::kTexture;
    if (quality.blur_sigma_px > kMaxBlurShare * quality.longer_side_px) return CaptureReason::kBlur;
    return std::nullopt;
}

std::string picture_trouble_text(CaptureReason reason, const CaptureEvidence& evidence,
                                 std::size_t concerned) {
    const auto median = [&](auto value) {
        std::vector<double> values;
        for (const PhotographQuality& quality : evidence.photographs) {
            values.push_back(value(quality));
        }
        return median_of(std::move(values));
    };
    const std::string share =
        formatted(": %zu of %zu photographs", concerned, evidence.photographs.size());
    switch (reason) {
        case CaptureReason::kExposure:
            return "mostly black or white" + share +
                   formatted(" (%.0f %% of the middle one)",
                             100 * median([](const auto& q) { return q.clipped_share; }));
        case CaptureReason::kNoise:
            return "noisy" + share +
                   formatted(", %.0f grey levels of noise in the middle one",
                             median([](const auto& q) { return q.noise_sigma; }));
        case CaptureReason::kTexture:
            return "hardly any pattern" + share +
                   formatted(", a contrast of %.1f grey levels in the middle one",
                             median([](const auto& q) { return q.contrast(); }));
        default:
            return "blurred" + share +
                   formatted(", by about %.1f pixels at a width of %d",
                             median([](const auto& q) { return q.blur_sigma_px; }),
                             evidence.width_px);
    }
}

}  // namespace lumi
