#include "calib/poses/stated_uncertainty.h"

#include <algorithm>

#include "calib/doctor/capture_reason.h"
#include "calib/work/formatted.h"

namespace lumi {
namespace {

/// Ghosts begin to show where surfaces of two photographs are blended that far apart.
constexpr double kMaxJitter_px = 0.3;

void warn_of_jitter(const std::vector<ViewUncertainty>& views, std::vector<std::string>& warnings) {
    const auto uncertain = std::count_if(views.begin(), views.end(), [](const auto& view) {
        return view.jitter_px > kMaxJitter_px;
    });
    if (uncertain == 0) return;
    const auto worst =
        std::max_element(views.begin(), views.end(),
                         [](const auto& a, const auto& b) { return a.jitter_px < b.jitter_px; });
    warnings.push_back(
        formatted("%td of %zu photographs are placed to no better than 0.3 px (%s: %.2g px): "
                  "blended pictures may show ghosts. Add photographs that overlap more, or "
                  "calibrate the lens with a board",
                  uncertain, views.size(), worst->name.c_str(), worst->jitter_px));
}

void warn_of_uncertain_places(const Capture& capture, const std::vector<ViewUncertainty>& views,
                              std::vector<std::string>& warnings) {
    const auto [uncertain, worst] = place_uncertainty(capture, views);
    if (uncertain == 0) return;
    warnings.push_back(
        std::string(code_of(CaptureReason::kUncertain)) +
        formatted(": %d of %zu photographs may have been taken elsewhere by as much as %.0f %% of "
                  "the cameras' spread, or turned by %.1f degrees; ",
                  uncertain, views.size(), 100 * worst.position_share, worst.rotation_deg) +
        std::string(advice_for(CaptureReason::kUncertain)) +
        ", or calibrate the lens with a board and give it ([calibration])");
}

}  // namespace

PlaceUncertainty place_uncertainty(const Capture& capture,
                                   const std::vector<ViewUncertainty>& views) {
    constexpr double kDeviations = 2.0;  // 95 of 100 errors are smaller.
    const double spread = spread_of_centres(named_poses(capture));
    PlaceUncertainty uncertainty;
    for (const ViewUncertainty& view : views) {
        const PoseShift shift{1, kDeviations * view.position_sigma / spread,
                              kDeviations * view.rotation_sigma_deg};
        uncertainty.views += shift.matters() ? 1 : 0;
        PoseShift& worst = uncertainty.worst;
        worst.position_share = std::max(worst.position_share, shift.position_share);
        worst.rotation_deg = std::max(worst.rotation_deg, shift.rotation_deg);
    }
    return uncertainty;
}

std::vector<std::string> warnings_of_uncertainty(const Capture& capture,
                                                 const std::vector<ViewUncertainty>& views) {
    if (views.empty()) {
        return {
            "how certain poses and lenses are is not known: there are too many photographs, or "
            "too little speaks for them"};
    }
    std::vector<std::string> warnings;
    warn_of_jitter(views, warnings);
    warn_of_uncertain_places(capture, views, warnings);
    return warnings;
}

}  // namespace lumi
