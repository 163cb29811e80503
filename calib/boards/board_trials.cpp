#include "calib/boards/board_trials.h"

#include <cmath>
#include <limits>

#include "calib/boards/calibration_evidence.h"
#include "calib/boards/lens_certainty.h"

namespace lumi {

LensTrial trial_of(const BoardViews& board, const LensFit& fit) {
    LensTrial trial;
    trial.form = fit.solution.form;
    trial.parameters_beside = free_parameters_of_board(fit.solution);
    if (fit.solution.is_bent) trial.beside = "bent board";
    trial.lens = fit.solution.lens;
    trial.sigma.assign(trial.lens.parameters.size(), 0.0);
    trial.residual_sum_px2 = fit.residual_sum_px2;
    trial.residuals = fit.residuals;
    if (!fit.is_usable) {
        trial.residual_sum_px2 = std::numeric_limits<double>::infinity();
        trial.not_predicted = "the fit failed";
        return trial;
    }
    trial.not_predicted = fault_within(board, fit.solution.lens);
    if (!trial.not_predicted.empty()) return trial;
    const std::vector<ReducedView> views = reduced_views(board, fit.solution);
    const LensCertainty certainty = lens_certainty(views, fit.solution.form);
    if (certainty.covariance.size() == 0) {
        trial.not_predicted = "not determined";
        return trial;
    }
    for (std::size_t index = 0; index < trial.sigma.size(); ++index) {
        const auto diagonal = static_cast<Eigen::Index>(index);
        trial.sigma[index] = std::sqrt(certainty.covariance(diagonal, diagonal));
    }
    trial.folds = held_out_photographs(views);
    if (trial.folds.empty()) trial.not_predicted = "not determined without every photograph";
    return trial;
}

LensChoice choose_that_explains(std::vector<LensTrial> trials) {
    double least_px2 = std::numeric_limits<double>::infinity();
    for (const LensTrial& trial : trials) {
        HeldOutFold all;
        for (const HeldOutFold& fold : trial.folds) {
            all.squared_error_px2 += fold.squared_error_px2;
            all.residuals += fold.residuals;
        }
        if (all.is_usable()) least_px2 = std::min(least_px2, all.squared_error_px2 / all.residuals);
    }
    constexpr double kClearlyWorse = 1.25 * 1.25;
    for (LensTrial& trial : trials) {
        if (trial.folds.empty() ||
            trial.residual_sum_px2 <= kClearlyWorse * least_px2 * trial.residuals) {
            continue;
        }
        trial.folds.clear();
        trial.not_predicted = "fits worse than another predicts";
    }
    return choose_lens(std::move(trials));
}

}  // namespace lumi
