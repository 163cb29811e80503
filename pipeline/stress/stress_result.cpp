#include "pipeline/stress/stress_result.h"

namespace lumi {

std::optional<double> breaking_point_of(const StressCurve& curve, double max_loss_db) {
    for (std::size_t i = 1; i < curve.psnr_db.size(); ++i) {
        const double loss = curve.psnr_db.front() - curve.psnr_db[i];
        if (loss < max_loss_db) continue;
        const double before = curve.psnr_db.front() - curve.psnr_db[i - 1];
        const double share = (max_loss_db - before) / (loss - before);
        return curve.strengths[i - 1] + share * (curve.strengths[i] - curve.strengths[i - 1]);
    }
    return std::nullopt;
}

}  // namespace lumi
