#include "calib/lens/lens_support.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace lumi {
namespace {

constexpr double kStandardDeviations = 2.0;

/// Linear conditions on the parameters under which a part of the lens says nothing.
struct Condition {
    std::string name;
    std::vector<int> held;    ///< The parameters that are then held.
    Eigen::MatrixXd rows;     ///< One row a condition.
    Eigen::VectorXd neutral;  ///< rows * parameters, when the part says nothing.
};

class Elimination {
 public:
    Elimination(const Camera& lens, const LensForm& form, const Eigen::MatrixXd& covariance)
        : lens_(lens),
          names_(parameter_names(form.model)),
          values_(Eigen::Map<const Eigen::VectorXd>(
              lens.parameters.data(), static_cast<Eigen::Index>(lens.parameters.size()))),
          covariance_(covariance) {
        list_conditions(form);
    }

    void run() {
        while (!conditions_.empty()) {
            const auto least = std::min_element(
                conditions_.begin(), conditions_.end(),
                [&](const auto& a, const auto& b) { return deviations(a) < deviations(b); });
            if (deviations(*least) >= kStandardDeviations) break;
            impose(*least);
            conditions_.erase(least);
        }
    }

    [[nodiscard]] const Eigen::VectorXd& values() const { return values_; }
    [[nodiscard]] const std::vector<int>& held() const { return held_; }
    [[nodiscard]] bool has_square_pixels() const { return square_pixels_; }
    [[nodiscard]] const std::vector<std::string>& dropped() const { return dropped_; }

 private:
    void list_conditions(const LensForm& form) {
        const Eigen::Index count = values_.size();
        const auto unit = [&](int index) -> Eigen::RowVectorXd {
            return Eigen::RowVectorXd::Unit(count, index);
        };
        for (int index = static_cast<int>(first_distortion_parameter(form.model)); index < count;
             ++index) {
            if (is_held(form, index)) continue;
            conditions_.push_back({names_[static_cast<std::size_t>(index)],
                                   {index},
                                   unit(index),
                                   Eigen::VectorXd::Zero(1)});
        }
        const int cx = has_one_focal_length(form.model) ? 1 : 2;
        if (!is_held(form, cx) && !is_held(form, cx + 1)) {
            Eigen::MatrixXd rows(2, count);
            rows << unit(cx), unit(cx + 1);
            conditions_.push_back({"cx cy",
                                   {cx, cx + 1},
                                   rows,
                                   Eigen::Vector2d(0.5 * lens_.width_px, 0.5 * lens_.height_px)});
        }
        if (cx == 2 && !is_held(form, 0) && !is_held(form, 1)) {
            conditions_.push_back({"fy - fx", {}, unit(1) - unit(0), Eigen::VectorXd::Zero(1)});
        }
    }

    [[nodiscard]] Eigen::VectorXd difference(const Condition& condition) const {
        return condition.rows * values_ - condition.neutral;
    }

    /// How many standard deviations the part is off neutral; of a principal point, the larger.
    [[nodiscard]] double deviations(const Condition& condition) const {
        const Eigen::VectorXd off = difference(condition);
        const Eigen::VectorXd variance =
            (condition.rows * covariance_ * condition.rows.transpose()).diagonal();
        double most = 0;
        for (Eigen::Index row = 0; row < off.size(); ++row) {
            if (off[row] == 0) continue;
            most = std::max(most, variance[row] > 0 ? std::abs(off[row]) / std::sqrt(variance[row])
                                                    : std::numeric_limits<double>::infinity());
        }
        return most;
    }

    /// The least squares solution under the condition, and its covariance.
    void impose(const Condition& condition) {
        note(condition);
        const Eigen::MatrixXd spread = covariance_ * condition.rows.transpose();
        const auto inverse = (condition.rows * spread).completeOrthogonalDecomposition();
        values_ -= spread * inverse.solve(difference(condition));
        covariance_ -= spread * inverse.solve(spread.transpose());
        // Exactly: what rounding leaves of either, the next condition would spread.
        for (std::size_t index = 0; index < condition.held.size(); ++index) {
            const int held = condition.held[index];
            values_[held] = condition.neutral[static_cast<Eigen::Index>(index)];
            covariance_.row(held).setZero();
            covariance_.col(held).setZero();
        }
        if (condition.held.empty()) square_pixels_ = true;
        held_.insert(held_.end(), condition.held.begin(), condition.held.end());
        std::sort(held_.begin(), held_.end());
    }

    void note(const Condition& condition) {
        const Eigen::VectorXd variance =
            (condition.rows * covariance_ * condition.rows.transpose()).diagonal();
        const Eigen::VectorXd value = condition.rows * values_;
        std::string text = condition.name + " =";
        for (Eigen::Index row = 0; row < value.size(); ++row) {
            std::array<char, 80> number{};
            std::snprintf(number.data(), number.size(), " %.4g +- %.2g", value[row],
                          std::sqrt(std::max(0.0, variance[row])));
            text += number.data();
        }
        dropped_.push_back(text);
    }

    const Camera& lens_;
    std::vector<std::string> names_;
    Eigen::VectorXd values_;
    Eigen::MatrixXd covariance_;
    std::vector<Condition> conditions_;
    std::vector<int> held_;
    bool square_pixels_ = false;
    std::vector<std::string> dropped_;
};

/// True when `model` can express the lens with these parameters of `form.model` held neutral.
bool can_express(LensModel model, const LensForm& form, bool square_pixels) {
    if (model == form.model) return true;
    if (!is_nested_in(model, form.model)) return false;
    if (has_one_focal_length(model) && !has_one_focal_length(form.model) && !square_pixels) {
        return false;
    }
    const std::vector<std::string> names = parameter_names(form.model);
    for (std::size_t index = first_distortion_parameter(form.model); index < names.size();
         ++index) {
        if (!parameter_named(model, names[index]) && !is_held(form, static_cast<int>(index))) {
            return false;
        }
    }
    return true;
}

}  // namespace

SupportedLens supported_lens(const Camera& lens, const LensForm& form,
                             const Eigen::MatrixXd& covariance) {
    Elimination elimination(lens, form, covariance);
    elimination.run();
    LensForm left = form;
    left.held.insert(left.held.end(), elimination.held().begin(), elimination.held().end());
    std::sort(left.held.begin(), left.held.end());
    Camera start = lens;
    std::copy_n(elimination.values().data(), start.parameters.size(), start.parameters.begin());

    // Parameters that were held from the beginning may be anything: only neutral ones can go.
    LensForm neutral = left;
    std::erase_if(neutral.held, [&](int index) {
        return start.parameters[static_cast<std::size_t>(index)] != 0.0;
    });
    LensModel model = form.model;
    for (const LensModel simpler :
         {LensModel::kFullOpenCv, LensModel::kOpenCv, LensModel::kRadial, LensModel::kPinhole,
          LensModel::kSimpleRadial, LensModel::kSimplePinhole}) {
        if (parameter_count(simpler) <= parameter_count(model) &&
            can_express(simpler, neutral, elimination.has_square_pixels())) {
            model = simpler;
        }
    }
    SupportedLens supported{{model, {}}, in_model(start, model), elimination.dropped()};
    const std::vector<std::string> names = parameter_names(form.model);
    for (const int index : left.held) {
        const auto same = parameter_named(model, names[static_cast<std::size_t>(index)]);
        if (same) supported.form.held.push_back(*same);
    }
    std::sort(supported.form.held.begin(), supported.form.held.end());
    return supported;
}

}  // namespace lumi
