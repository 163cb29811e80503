#include "calib/boards/lens_certainty.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

/// Parameters differ by many orders of magnitude: scaled so that the diagonal is 1.
class ScaledInverse {
 public:
    explicit ScaledInverse(const Eigen::MatrixXd& information)
        : scale_(information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse()),
          solver_(scale_.asDiagonal() * information * scale_.asDiagonal()) {
        constexpr double kLeastPivot = 1e-13;
        is_regular_ = solver_.info() == Eigen::Success && solver_.isPositive() &&
                      solver_.vectorD().minCoeff() > kLeastPivot;
        if (!is_regular_) return;
        root_ = scale_.asDiagonal() * information * scale_.asDiagonal();
        root_ = Eigen::MatrixXd(root_.llt().matrixL());
    }
    [[nodiscard]] bool is_regular() const { return is_regular_; }
    [[nodiscard]] Eigen::MatrixXd times(const Eigen::MatrixXd& right) const {
        return scale_.asDiagonal() * solver_.solve(scale_.asDiagonal() * right);
    }
    /// Where the information is the identity.
    [[nodiscard]] Eigen::VectorXd whitened(const Eigen::VectorXd& change) const {
        const Eigen::VectorXd scaled = change.cwiseQuotient(scale_);
        return root_.transpose() * scaled;
    }
    [[nodiscard]] Eigen::MatrixXd unwhitened(const Eigen::MatrixXd& covariance) const {
        const Eigen::MatrixXd back = root_.transpose().triangularView<Eigen::Upper>().solve(
            Eigen::MatrixXd::Identity(root_.rows(), root_.cols()));
        return scale_.asDiagonal() * back * covariance * back.transpose() * scale_.asDiagonal();
    }

 private:
    Eigen::VectorXd scale_;
    Eigen::MatrixXd root_;  ///< Lower triangle.
    Eigen::LDLT<Eigen::MatrixXd> solver_;
    bool is_regular_ = false;
};

Eigen::MatrixXd total_information(const std::vector<ReducedView>& views) {
    Eigen::MatrixXd total = views.front().information;
    for (std::size_t index = 1; index < views.size(); ++index) total += views[index].information;
    return total;
}

/// What leaving out each photograph changes in the shared parameters; empty: not determined.
std::vector<Eigen::VectorXd> changes_without_each(const std::vector<ReducedView>& views) {
    const Eigen::MatrixXd total = total_information(views);
    std::vector<Eigen::VectorXd> changes;
    for (const ReducedView& view : views) {
        const ScaledInverse inverse(total - view.information);
        if (!inverse.is_regular()) return {};
        changes.emplace_back(inverse.times(view.gradient));
    }
    return changes;
}

/// The jackknife's covariance, whitened by the information.
Eigen::MatrixXd scatter_of(const std::vector<Eigen::VectorXd>& changes,
                           const ScaledInverse& inverse) {
    const auto count = static_cast<double>(changes.size());
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(changes.front().size());
    for (const Eigen::VectorXd& change : changes) mean += change / count;
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(mean.size(), mean.size());
    for (const Eigen::VectorXd& change : changes) {
        const Eigen::VectorXd white = inverse.whitened(change - mean);
        scatter += (count - 1) / count * white * white.transpose();
    }
    return scatter;
}

/// The pooled disagreement in every direction, and where photographs disagree more in one, such as
/// about their zoom, that: beyond what chance makes the largest of so many directions (Marchenko
/// and Pastur, Distribution of eigenvalues for some sets of random matrices, 1967), or in any of
/// them where photographs clearly disagree.
Eigen::MatrixXd contained(const Eigen::MatrixXd& scatter, double pooled, std::size_t views) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> directions(scatter);
    const double ratio = static_cast<double>(scatter.rows()) / static_cast<double>(views - 1);
    constexpr double kClearly = 4;
    const double by_chance =
        pooled > kClearly ? pooled : pooled * (1 + std::sqrt(ratio)) * (1 + std::sqrt(ratio));
    const Eigen::VectorXd widened =
        (directions.eigenvalues().array() > by_chance)
            .select(directions.eigenvalues(), Eigen::VectorXd::Constant(scatter.rows(), pooled));
    return directions.eigenvectors() * widened.asDiagonal() * directions.eigenvectors().transpose();
}

}  // namespace

double residual_sum_after_px2(const ReducedView& view, const Eigen::VectorXd& change) {
    return view.residual_sum_px2 + 2 * change.dot(view.gradient) +
           change.dot(view.information * change);
}

std::optional<LinearStep> step_to_minimum(const std::vector<ReducedView>& views) {
    const ScaledInverse inverse(total_information(views));
    if (!inverse.is_regular()) return std::nullopt;
    Eigen::VectorXd gradient = views.front().gradient;
    for (std::size_t index = 1; index < views.size(); ++index) gradient += views[index].gradient;
    LinearStep step{-inverse.times(gradient), views};
    for (ReducedView& view : step.views) {
        view.residual_sum_px2 = residual_sum_after_px2(view, step.change);
        view.gradient += view.information * step.change;
    }
    return step;
}

std::vector<HeldOutFold> held_out_photographs(const std::vector<ReducedView>& views) {
    constexpr std::size_t kLeastViews = 3;
    if (views.size() < kLeastViews) return {};
    const std::vector<Eigen::VectorXd> changes = changes_without_each(views);
    std::vector<HeldOutFold> folds;
    for (std::size_t index = 0; index < changes.size(); ++index) {
        const ReducedView& view = views[index];
        folds.push_back({residual_sum_after_px2(view, changes[index]), view.residuals});
    }
    return folds;
}

LensCertainty lens_certainty(const std::vector<ReducedView>& views, const LensForm& form) {
    LensCertainty certainty;
    const Eigen::MatrixXd total = total_information(views);
    const ScaledInverse inverse(total);
    const std::vector<Eigen::VectorXd> changes = changes_without_each(views);
    double residual_sum = 0;
    int residuals = 0;
    for (const ReducedView& view : views) {
        residual_sum += view.residual_sum_px2;
        residuals += view.residuals;
    }
    const auto shared = static_cast<int>(total.rows());
    certainty.degrees_of_freedom = residuals - shared - 6 * static_cast<int>(views.size());
    if (!inverse.is_regular() || certainty.degrees_of_freedom <= 0) return certainty;
    const double variance_px2 = residual_sum / certainty.degrees_of_freedom;
    certainty.point_sigma_px = std::sqrt(variance_px2);

    Eigen::MatrixXd spread = Eigen::MatrixXd::Identity(shared, shared);
    if (!changes.empty() && variance_px2 > 0) {
        const Eigen::MatrixXd scatter = scatter_of(changes, inverse) / variance_px2;
        certainty.disagreement = std::max(1.0, scatter.trace() / shared);
        spread = contained(scatter, certainty.disagreement, views.size());
    }
    const std::vector<int> free = free_parameter_indices(form);
    const auto lens_count = static_cast<Eigen::Index>(parameter_count(form.model));
    const Eigen::MatrixXd of_shared = variance_px2 * inverse.unwhitened(spread);
    certainty.covariance = Eigen::MatrixXd::Zero(lens_count, lens_count);
    for (std::size_t row = 0; row < free.size(); ++row) {
        for (std::size_t column = 0; column < free.size(); ++column) {
            certainty.covariance(free[row], free[column]) =
                of_shared(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
        }
    }
    const auto beside = static_cast<Eigen::Index>(shared) - static_cast<Eigen::Index>(free.size());
    certainty.of_board = of_shared.bottomRightCorner(beside, beside);
    return certainty;
}

}  // namespace lumi
