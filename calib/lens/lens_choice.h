#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calib/lens/lens_form.h"

namespace lumi {

/// How well a fit predicts one group of pixels that took no part in it, a photograph for example.
struct HeldOutFold {
    double squared_error_px2 = 0.0;  ///< Sum over the residuals.
    int residuals = 0;               ///< Two for each point.

    /// False: nothing of the group could be predicted, and it says nothing of the lens.
    [[nodiscard]] bool is_usable() const { return residuals > 0; }
};
[[nodiscard]] bool any_usable(const std::vector<HeldOutFold>& folds);

/// One form of a lens, tried: what a fit to everything gave, and what fits to parts predicted.
struct LensTrial {
    LensForm form;
    /// What was estimated beside lens and poses, such as "bent board", and its parameters.
    std::string beside;
    int parameters_beside = 0;
    Camera lens;                    ///< Fitted to everything.
    std::vector<double> sigma;      ///< Standard deviation of each parameter; 0 where it is held.
    double residual_sum_px2 = 0.0;  ///< Of that fit: the sum of squares.
    int residuals = 0;              ///< Of that fit: two for each point.
    /// The same groups of the same pixels in every trial; empty: not predicted. Unusable ones are
    /// skipped.
    std::vector<HeldOutFold> folds;
    std::string not_predicted;  ///< Why `folds` is empty.
    /// What speaks against the lens in those parts of the picture where nothing was seen
    /// (lens_fault); empty: nothing.
    std::string fault_beyond_seen;

    // Set by choose_lens, which also empties `folds` of which none is usable:
    double rms_px = 0.0;            ///< Root mean square of a residual (one coordinate), fitted.
    double held_out_rms_px = 0.0;   ///< The same of what was predicted; 0 without folds.
    double excess_px2 = 0.0;        ///< Mean square that is predicted worse than by the best.
    double excess_sigma_px2 = 0.0;  ///< One standard error of `excess_px2`.
    double bic = 0.0;               ///< n ln(RSS / n) + k ln n (Schwarz 1978).
};

/// Of the lens and of what was estimated beside it.
[[nodiscard]] int free_parameters(const LensTrial& trial);
/// "RADIAL, k2 held", and what was estimated beside the lens.
[[nodiscard]] std::string text_of(const LensTrial& trial);

/// Which form of a lens the photographs support, and what speaks for it.
struct LensChoice {
    std::vector<LensTrial> trials;  ///< Fewest free parameters first.
    std::size_t chosen = 0;
    std::size_t best_predicting = 0;  ///< Least held-out error.
    std::size_t least_bic = 0;

    [[nodiscard]] const LensTrial& choice() const { return trials[chosen]; }
};

/// The form with the fewest free parameters whose held-out error is within one standard error of
/// the least (Breiman et al., Classification and Regression Trees, 1984, section 3.4.3), or so
/// little above it that nobody could see it: by less than a hundredth of the mean square, half a
/// hundredth of the RMS. The best of a dozen forms is better by as much by chance, and what speaks
/// for that little are the errors of the features, not the lens.
///
/// The standard error is that of the difference to the best predicting form, paired over folds:
/// what makes one photograph harder than another is common to all forms and tells nothing about
/// them. Folds count by their residuals (ratio estimator: Cochran, Sampling Techniques, 1977,
/// section 2.11). Forms without folds are not chosen unless none has any: then the least BIC
/// decides. BIC stands beside it in any case; it prefers too many parameters where errors of
/// neighbouring pixels are alike. What is seen in the middle of the picture alone says nothing of
/// its corners: a form with a fault there gives way to the simplest without that does not surely
/// predict worse (three standard errors). Expects at least one trial, and folds of equal number.
[[nodiscard]] LensChoice choose_lens(std::vector<LensTrial> trials);

/// The choice (index into `choice.trials`) among the forms alone that hold the principal point,
/// where there is reason to doubt that photographs tell it. Empty when no form does, and when the
/// one that would be chosen surely predicts worse (three standard errors) than the best of all:
/// then the photographs do tell.
[[nodiscard]] std::optional<std::size_t> choice_with_principal_point_held(const LensChoice& choice);

/// True when a form surely predicts worse than `best`, so that its folds need not be fitted: the
/// error of its fit on its own data (`fitted`, by the groups of the folds), which is less than it
/// would predict, lies three standard errors above, paired as in choose_lens.
[[nodiscard]] bool predicts_worse_surely(const std::vector<HeldOutFold>& fitted,
                                         const std::vector<HeldOutFold>& best);

/// The choice as a table: form, parameters, RMS, held-out RMS, excess, BIC, verdict.
[[nodiscard]] std::string lens_choice_table(const LensChoice& choice);

}  // namespace lumi
