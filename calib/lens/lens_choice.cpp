#include "calib/lens/lens_choice.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "calib/work/formatted.h"

namespace lumi {
namespace {

double residuals_of(const std::vector<HeldOutFold>& folds) {
    double count = 0;
    for (const HeldOutFold& fold : folds) count += fold.residuals;
    return count;
}

double mean_square_px2(const std::vector<HeldOutFold>& folds) {
    double sum = 0;
    for (const HeldOutFold& fold : folds) sum += fold.squared_error_px2;
    return sum / std::max(1.0, residuals_of(folds));
}

/// By how much one fold is predicted worse than in another trial.
struct FoldDifference {
    double squared_error_px2 = 0.0;
    int residuals = 0;
};

/// By how much the mean square of one list lies above that of the other, and one standard error,
/// from how folds differ.
struct Excess {
    double mean_px2 = 0.0;
    double sigma_px2 = 0.0;
};

Excess excess_of(const std::vector<HeldOutFold>& folds, const std::vector<HeldOutFold>& best) {
    assert(folds.size() == best.size());
    std::vector<FoldDifference> differences;
    double sum = 0;
    double total = 0;
    for (std::size_t fold = 0; fold < folds.size(); ++fold) {
        if (!folds[fold].is_usable() || !best[fold].is_usable()) continue;
        differences.push_back(
            {folds[fold].squared_error_px2 - best[fold].squared_error_px2, folds[fold].residuals});
        sum += differences.back().squared_error_px2;
        total += differences.back().residuals;
    }
    if (differences.empty()) return {};
    const double mean_px2 = sum / total;
    if (differences.size() < 2) return {mean_px2, 0.0};
    double squares = 0;
    for (const FoldDifference& difference : differences) {
        const double deviation = difference.squared_error_px2 - mean_px2 * difference.residuals;
        squares += deviation * deviation;
    }
    const double count = static_cast<double>(differences.size());
    return {mean_px2, std::sqrt(count / (count - 1) * squares) / total};
}

void measure(LensTrial& trial) {
    const double n = std::max(1, trial.residuals);
    const double mean_square = trial.residual_sum_px2 / n;
    // A fit without any error would have no logarithm: no photograph is that exact.
    constexpr double kLeastMeanSquare_px2 = 1e-12;
    trial.rms_px = std::sqrt(mean_square);
    trial.bic = n * std::log(std::max(mean_square, kLeastMeanSquare_px2)) +
                free_parameters(trial) * std::log(n);
    if (!any_usable(trial.folds)) trial.folds.clear();
    trial.held_out_rms_px = std::sqrt(mean_square_px2(trial.folds));
}

template <class Value>
std::size_t least(const std::vector<LensTrial>& trials, Value value_of) {
    return static_cast<std::size_t>(std::min_element(trials.begin(), trials.end(),
                                                     [&](const LensTrial& a, const LensTrial& b) {
                                                         return value_of(a) < value_of(b);
                                                     }) -
                                    trials.begin());
}

std::string verdict_of(const LensChoice& choice, std::size_t index) {
    std::string verdict;
    const auto add = [&](const std::string& word) {
        verdict += (verdict.empty() ? "" : ", ") + word;
    };
    if (index == choice.chosen) add("chosen");
    if (index == choice.best_predicting && !choice.trials[index].folds.empty()) {
        add("predicts best");
    }
    if (index == choice.least_bic) add("least BIC");
    if (choice.trials[index].folds.empty() && !choice.trials[index].not_predicted.empty()) {
        add(choice.trials[index].not_predicted);
    }
    if (!choice.trials[index].fault_beyond_seen.empty()) {
        add(choice.trials[index].fault_beyond_seen + " beyond what was seen");
    }
    return verdict;
}

constexpr double kSureStandardErrors = 3.0;
/// Of the held-out mean square: no more than this is no reason for a richer form.
constexpr double kImmaterialShare = 0.01;

/// Of the forms without a fault beyond what was seen, the simplest that does not surely predict
/// worse than the best; the chosen one where there is none.
std::size_t sound_choice(const LensChoice& choice) {
    if (choice.choice().fault_beyond_seen.empty()) return choice.chosen;
    for (std::size_t index = 0; index < choice.trials.size(); ++index) {
        const LensTrial& trial = choice.trials[index];
        if (!trial.folds.empty() && trial.fault_beyond_seen.empty() &&
            trial.excess_px2 <= kSureStandardErrors * trial.excess_sigma_px2) {
            return index;
        }
    }
    return choice.chosen;
}

}  // namespace

bool any_usable(const std::vector<HeldOutFold>& folds) {
    return std::any_of(folds.begin(), folds.end(),
                       [](const HeldOutFold& fold) { return fold.is_usable(); });
}

int free_parameters(const LensTrial& trial) {
    return free_parameters(trial.form) + trial.parameters_beside;
}

std::string text_of(const LensTrial& trial) {
    return text_of(trial.form) + (trial.beside.empty() ? "" : ", " + trial.beside);
}

LensChoice choose_lens(std::vector<LensTrial> trials) {
    assert(!trials.empty());
    std::stable_sort(trials.begin(), trials.end(), [](const LensTrial& a, const LensTrial& b) {
        return free_parameters(a) < free_parameters(b);
    });
    for (LensTrial& trial : trials) measure(trial);
    LensChoice choice;
    choice.trials = std::move(trials);
    const auto& all = choice.trials;
    choice.least_bic = least(all, [](const LensTrial& trial) { return trial.bic; });
    choice.best_predicting = least(all, [](const LensTrial& trial) {
        return trial.folds.empty() ? HUGE_VAL : trial.held_out_rms_px;
    });
    if (all[choice.best_predicting].folds.empty()) {
        choice.chosen = choice.best_predicting = choice.least_bic;
        return choice;
    }
    const LensTrial best = all[choice.best_predicting];
    choice.chosen = choice.best_predicting;
    for (std::size_t index = choice.trials.size(); index-- > 0;) {
        LensTrial& trial = choice.trials[index];
        if (trial.folds.empty()) continue;
        const Excess excess = excess_of(trial.folds, best.folds);
        trial.excess_px2 = excess.mean_px2;
        trial.excess_sigma_px2 = excess.sigma_px2;
        const bool is_simpler = free_parameters(trial) < free_parameters(choice.choice());
        const double immaterial_px2 =
            kImmaterialShare * best.held_out_rms_px * best.held_out_rms_px;
        const bool predicts_as_well =
            trial.excess_px2 <= std::max(trial.excess_sigma_px2, immaterial_px2);
        // Of two with as many parameters the one that predicts better.
        const bool is_better_equal = free_parameters(trial) == free_parameters(choice.choice()) &&
                                     trial.held_out_rms_px < choice.choice().held_out_rms_px;
        if (predicts_as_well && (is_simpler || is_better_equal)) choice.chosen = index;
    }
    choice.chosen = sound_choice(choice);
    return choice;
}

std::optional<std::size_t> choice_with_principal_point_held(const LensChoice& choice) {
    std::vector<LensTrial> held;
    for (const LensTrial& trial : choice.trials) {
        if (holds_principal_point(trial.form)) held.push_back(trial);
    }
    if (held.empty()) return std::nullopt;
    const LensForm form = choose_lens(std::move(held)).choice().form;
    const auto found = std::find_if(choice.trials.begin(), choice.trials.end(),
                                    [&](const LensTrial& trial) { return trial.form == form; });
    const bool is_predicted = !found->folds.empty() || choice.choice().folds.empty();
    const double best_px = choice.trials[choice.best_predicting].held_out_rms_px;
    const double allowed_px2 = std::max(kSureStandardErrors * found->excess_sigma_px2,
                                        kImmaterialShare * best_px * best_px);
    if (!is_predicted || found->excess_px2 > allowed_px2) return std::nullopt;
    return static_cast<std::size_t>(found - choice.trials.begin());
}

bool predicts_worse_surely(const std::vector<HeldOutFold>& fitted,
                           const std::vector<HeldOutFold>& best) {
    const Excess excess = excess_of(fitted, best);
    return excess.mean_px2 > kSureStandardErrors * excess.sigma_px2 && excess.mean_px2 > 0;
}

std::string lens_choice_table(const LensChoice& choice) {
    std::size_t width = 4;
    for (const LensTrial& trial : choice.trials) {
        width = std::max(width, text_of(trial).size());
    }
    const int column = static_cast<int>(width);
    std::string table = formatted(
        "%-*s  free  RMS px  held-out px  excess +- 1 SE (px^2)       BIC\n", column, "lens");
    for (std::size_t index = 0; index < choice.trials.size(); ++index) {
        const LensTrial& trial = choice.trials[index];
        table += formatted("%-*s  %4d  %6.4f  ", column, text_of(trial).c_str(),
                           free_parameters(trial), trial.rms_px);
        table += trial.folds.empty() ? formatted("%11s  %22s", "-", "-")
                                     : formatted("%11.4f  %10.6f +- %8.6f", trial.held_out_rms_px,
                                                 trial.excess_px2, trial.excess_sigma_px2);
        table += formatted("  %9.1f  %s\n", trial.bic, verdict_of(choice, index).c_str());
    }
    return table;
}

}  // namespace lumi
