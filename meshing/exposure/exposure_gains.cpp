#include "meshing/exposure/exposure_gains.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "calib/work/mean.h"
#include "calib/work/median.h"
#include "meshing/selection/one_standard_error.h"

namespace lumi {
namespace {

constexpr int kRounds = 8;
constexpr double kLeastSpread = 0.01;   // Of tiles: below that all is rounding.
constexpr double kPriorSigma = 0.35;    // Of the logarithm of a gain: half a stop.
constexpr double kLargestLog = 2.77;    // Four stops: beyond that nothing is left to even out.
constexpr double kLargestError = 0.25;  // A pair that is further off is no worse.
constexpr double kLeastGain = 0.01;
constexpr double kNoiseFactor = 2.0;
constexpr double kMostLeft = 0.15;
constexpr std::size_t kLeastPairs = 3;  // Fewer do not tell how much they differ.

/// Logarithms of gains, one row a view and one column a channel.
using LogGains = Eigen::MatrixX3d;
/// The logarithm of what a ratio says, of one fold or the mean of both.
using LogRatios = Eigen::MatrixX3d;

LogRatios fold_of(const std::vector<ExposureRatio>& ratios, std::size_t fold) {
    LogRatios result(static_cast<Eigen::Index>(ratios.size()), 3);
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        result.row(static_cast<Eigen::Index>(i)) = ratios[i].log_ratio[fold];
    }
    return result;
}

/// What gains change of a ratio: in the mean of the channels, where it tells no more.
Eigen::RowVector3d change_of(const ExposureRatio& ratio, const LogGains& gains) {
    const Eigen::RowVector3d change = gains.row(ratio.second) - gains.row(ratio.first);
    if (ratio.tells_white_balance) return change;
    return Eigen::RowVector3d::Constant(change.mean());
}

/// What the gains leave of each ratio: zero when both photographs become equally bright.
LogRatios residuals(const std::vector<ExposureRatio>& ratios, const LogRatios& log_ratios,
                    const LogGains& gains) {
    LogRatios result = log_ratios;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        result.row(static_cast<Eigen::Index>(i)) += change_of(ratios[i], gains);
    }
    return result;
}

double sigma_of(const ExposureRatio& ratio) { return std::hypot(ratio.spread, kLeastSpread); }

/// Weights of the pairs for the next round: by what their tiles agree to, and robust (Cauchy,
/// at 1.5 times the median residual).
Eigen::VectorXd weights_for(const std::vector<ExposureRatio>& ratios, const LogRatios& left) {
    Eigen::VectorXd sizes(left.rows());
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        sizes[row] = left.row(row).norm() / sigma_of(ratios[i]);
    }
    const double scale = std::max(1.0, 1.5 * median_of({sizes.begin(), sizes.end()}));
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        double& entry = sizes[static_cast<Eigen::Index>(i)];
        entry = 1.0 / (std::pow(sigma_of(ratios[i]), 2) * (1.0 + std::pow(entry / scale, 2)));
    }
    return sizes;
}

/// Weighted least squares for all channels at once.
LogGains solved(int view_count, const std::vector<ExposureRatio>& ratios,
                const LogRatios& log_ratios, const Eigen::VectorXd& weights) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int view = 0; view < view_count; ++view) {
        entries.emplace_back(view, view, 1.0 / (kPriorSigma * kPriorSigma));
    }
    LogGains right = LogGains::Zero(view_count, 3);
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        const int first = ratios[i].first;
        const int second = ratios[i].second;
        const double weight = weights[static_cast<Eigen::Index>(i)];
        entries.emplace_back(first, first, weight);
        entries.emplace_back(second, second, weight);
        entries.emplace_back(first, second, -weight);
        entries.emplace_back(second, first, -weight);
        const Eigen::RowVector3d pull = weight * log_ratios.row(static_cast<Eigen::Index>(i));
        right.row(first) += pull;
        right.row(second) -= pull;
    }
    Eigen::SparseMatrix<double> normal(view_count, view_count);
    normal.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
    return solver.solve(right);
}

/// Of each view, whether a ratio tells how its channels differ from others'; all 1 where all do.
std::vector<char> tell_white_balance(int view_count, const std::vector<ExposureRatio>& ratios) {
    const bool do_all = std::all_of(ratios.begin(), ratios.end(),
                                    [](const auto& ratio) { return ratio.tells_white_balance; });
    std::vector<char> tell(static_cast<std::size_t>(view_count), do_all ? 1 : 0);
    for (const ExposureRatio& ratio : ratios) {
        if (!ratio.tells_white_balance) continue;
        tell[static_cast<std::size_t>(ratio.first)] = 1;
        tell[static_cast<std::size_t>(ratio.second)] = 1;
    }
    return tell;
}

bool do_all(const std::vector<char>& tell) {
    return std::find(tell.begin(), tell.end(), 0) == tell.end();
}

/// What photographs have in common in all channels is asked of all ratios, how channels differ of
/// those that tell it: a view of which none does gets one gain for all channels.
LogGains solved_in_parts(int view_count, const std::vector<ExposureRatio>& ratios,
                         const LogRatios& log_ratios, const Eigen::VectorXd& weights) {
    const LogRatios common = log_ratios.rowwise().mean().replicate(1, 3);
    Eigen::VectorXd of_colors = weights;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        if (!ratios[i].tells_white_balance) of_colors[static_cast<Eigen::Index>(i)] = 0.0;
    }
    return solved(view_count, ratios, common, weights) +
           solved(view_count, ratios, log_ratios - common, of_colors);
}

/// Makes the geometric mean of all gains 1 in each channel, without a difference between those of a
/// view that tells none.
void centre_gains(const std::vector<char>& tell, LogGains& gains) {
    if (do_all(tell)) {
        gains.rowwise() -= gains.colwise().mean().eval();
        return;
    }
    gains.array() -= gains.mean();
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double telling = 0;
    for (Eigen::Index i = 0; i < gains.rows(); ++i) {
        if (tell[static_cast<std::size_t>(i)] == 0) continue;
        sum.array() += gains.row(i).array() - gains.row(i).mean();
        ++telling;
    }
    for (Eigen::Index i = 0; i < gains.rows(); ++i) {
        if (tell[static_cast<std::size_t>(i)] != 0) gains.row(i) -= sum / telling;
    }
}

LogGains fitted(int view_count, const std::vector<ExposureRatio>& ratios, LogRatios log_ratios,
                ExposureModel model) {
    if (model == ExposureModel::kNone) return LogGains::Zero(view_count, 3);
    if (model == ExposureModel::kGain) {
        log_ratios = log_ratios.rowwise().mean().replicate(1, 3).eval();
    }
    const std::vector<char> tell = tell_white_balance(view_count, ratios);
    // Pairs are weighed by what their tiles agree to before anything is known of the gains.
    Eigen::VectorXd weights = weights_for(ratios, LogRatios::Zero(log_ratios.rows(), 3));
    LogGains gains = LogGains::Zero(view_count, 3);
    for (int round = 0; round < kRounds; ++round) {
        gains = do_all(tell) ? solved(view_count, ratios, log_ratios, weights)
                             : solved_in_parts(view_count, ratios, log_ratios, weights);
        weights = weights_for(ratios, residuals(ratios, log_ratios, gains));
    }
    centre_gains(tell, gains);
    gains = gains.cwiseMax(-kLargestLog).cwiseMin(kLargestLog).eval();
    centre_gains(tell, gains);
    return gains;
}

double rms_of(const Eigen::MatrixX3d& values) {
    return values.size() == 0
               ? 0.0
               : std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

/// A model, asked for what it was not fitted to.
struct ModelTrial {
    ExposureModel model = ExposureModel::kNone;
    std::vector<double> errors;  ///< Squared, all channels: one a pair, or one a tile of few pairs.
    double noise = 0.0;          ///< Root mean square of half of what the fits differ by.
};

double clipped_square(const Eigen::Vector3d& left) {
    return left.cwiseAbs().cwiseMin(kLargestError).squaredNorm();
}

/// One a pair: of both folds, each with the gains of the other.
std::vector<double> errors_of_pairs(const std::vector<ExposureRatio>& ratios,
                                    const std::array<LogGains, 2>& gains) {
    const LogRatios first = residuals(ratios, fold_of(ratios, 1), gains[0]);
    const LogRatios second = residuals(ratios, fold_of(ratios, 0), gains[1]);
    std::vector<double> errors;
    for (Eigen::Index i = 0; i < first.rows(); ++i)
        errors.push_back(clipped_square(first.row(i)) + clipped_square(second.row(i)));
    return errors;
}

/// One a tile, with the gains of the other fold.
std::vector<double> errors_of_tiles(const std::vector<ExposureRatio>& ratios,
                                    const std::array<LogGains, 2>& gains) {
    std::vector<double> errors;
    for (const ExposureRatio& ratio : ratios) {
        for (const std::size_t fold : {0U, 1U}) {
            const LogGains& of_other = gains[1 - fold];
            const Eigen::Vector3d evened = change_of(ratio, of_other);
            for (const Eigen::Vector3d& tile : ratio.tiles[fold])
                errors.push_back(clipped_square(tile + evened));
        }
    }
    return errors;
}

ModelTrial trial_of(ExposureModel model, int view_count, const std::vector<ExposureRatio>& ratios) {
    const std::array<LogGains, 2> gains{fitted(view_count, ratios, fold_of(ratios, 0), model),
                                        fitted(view_count, ratios, fold_of(ratios, 1), model)};
    return {model,
            ratios.size() < kLeastPairs ? errors_of_tiles(ratios, gains)
                                        : errors_of_pairs(ratios, gains),
            0.5 * rms_of(gains[0] - gains[1])};
}

/// Whether a model's errors exceed the best one's by no more than a standard error.
bool is_as_good(const ModelTrial& trial, const ModelTrial& best, std::size_t pairs,
                int view_count) {
    const Excess excess = excess_over(trial.errors, best.errors);
    if (pairs < kLeastPairs) return excess.mean <= excess.standard_error;
    return excess.mean <=
           standard_error_over_views(excess, pairs, static_cast<std::size_t>(view_count));
}

ModelTrial chosen_trial(int view_count, const std::vector<ExposureRatio>& ratios) {
    std::vector<ModelTrial> trials;
    for (const ExposureModel model :
         {ExposureModel::kNone, ExposureModel::kGain, ExposureModel::kChannelGains}) {
        trials.push_back(trial_of(model, view_count, ratios));
    }
    const auto best = *std::min_element(
        trials.begin(), trials.end(),
        [](const auto& a, const auto& b) { return mean_of(a.errors) < mean_of(b.errors); });
    return *std::find_if(trials.begin(), trials.end(), [&](const ModelTrial& trial) {
        return is_as_good(trial, best, ratios.size(), view_count);
    });
}

/// Whether gains are more than noise, and more than can be seen.
bool is_told(const LogGains& gains, double noise) {
    return rms_of(gains) >= std::max(kLeastGain, kNoiseFactor * noise);
}

double median_size(const LogRatios& log_ratios) {
    const Eigen::MatrixX3d sizes = log_ratios.cwiseAbs();
    return median_of({sizes.data(), sizes.data() + sizes.size()});
}

/// Whether it is exposure that photographs differ by: gains leave next to nothing of what the usual
/// pair differs by, however wrong others are; or of what all do, where so few photographs are
/// exposed in another way that the usual pair does not differ at all.
bool is_explained(const LogRatios& log_ratios, const LogRatios& left) {
    return median_size(left) <= kMostLeft * median_size(log_ratios) ||
           rms_of(left) <= kMostLeft * rms_of(log_ratios);
}

LogRatios mean_ratios(const std::vector<ExposureRatio>& ratios) {
    return 0.5 * (fold_of(ratios, 0) + fold_of(ratios, 1));
}

}  // namespace

std::string name_of(ExposureModel model) {
    switch (model) {
        case ExposureModel::kGain:
            return "gain";
        case ExposureModel::kChannelGains:
            return "channel_gains";
        case ExposureModel::kNone:
            break;
    }
    return "none";
}

ExposureGains exposure_gains(int view_count, const std::vector<ExposureRatio>& ratios) {
    ExposureGains result;
    result.gains.assign(static_cast<std::size_t>(view_count), {1.0, 1.0, 1.0});
    result.tell_white_balance = tell_white_balance(view_count, ratios);
    result.pairs = static_cast<int>(ratios.size());
    if (ratios.empty()) return result;
    const LogRatios log_ratios = mean_ratios(ratios);
    const double stops_per_log = std::numbers::log2e;
    result.difference_stops = result.remaining_stops = stops_per_log * rms_of(log_ratios);

    const ModelTrial trial = chosen_trial(view_count, ratios);
    const LogGains gains = fitted(view_count, ratios, log_ratios, trial.model);
    if (trial.model == ExposureModel::kNone || !is_told(gains, trial.noise)) return result;
    const LogRatios left = residuals(ratios, log_ratios, gains);
    if (!is_explained(log_ratios, left)) return result;
    result.model = trial.model;
    result.remaining_stops = stops_per_log * rms_of(left);
    result.largest_stops = stops_per_log * gains.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < gains.rows(); ++i) {
        for (Eigen::Index channel = 0; channel < 3; ++channel) {
            result.gains[static_cast<std::size_t>(i)][static_cast<std::size_t>(channel)] =
                std::exp(gains(i, channel));
        }
    }
    return result;
}

}  // namespace lumi
