#include "calib/lens/lens_form.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace lumi {
namespace {

/// The picture's corner that is farthest from the principal point, as an angle off the axis.
double largest_angle_rad(const Camera& lens) {
    double largest = 0;
    for (const double x : {0.0, static_cast<double>(lens.width_px)}) {
        for (const double y : {0.0, static_cast<double>(lens.height_px)}) {
            largest = std::max(largest, std::atan(unproject(lens, {x, y}).head<2>().norm()));
        }
    }
    return largest;
}

/// Distance from the principal point, for a focal length of 1, at which `lens` shows an angle.
double radius_at_angle(const Camera& lens, double angle_rad) {
    const Eigen::Vector3d direction(std::tan(angle_rad), 0, 1);
    const Eigen::Vector2d pixel = project(lens, direction).value();
    return (pixel - principal_point_px(lens)).cwiseQuotient(focal_length_px(lens)).norm();
}

/// k1..k4 of radius = angle (1 + k1 angle^2 + k2 angle^4 + ...).
Eigen::Vector4d fisheye_coefficients(const Camera& lens) {
    constexpr int kSamples = 64;
    const double largest_rad = largest_angle_rad(lens);
    Eigen::Matrix<double, kSamples, 4> powers;
    Eigen::Matrix<double, kSamples, 1> excess;
    for (int sample = 0; sample < kSamples; ++sample) {
        // In units of the largest angle, where the powers are of one size.
        const double share = (sample + 1.0) / kSamples;
        const double angle_rad = share * largest_rad;
        excess[sample] = radius_at_angle(lens, angle_rad) - angle_rad;
        for (int power = 0; power < 4; ++power) {
            powers(sample, power) = std::pow(share, 2 * power + 3);
        }
    }
    Eigen::Vector4d k = powers.colPivHouseholderQr().solve(excess);
    for (int power = 0; power < 4; ++power) k[power] /= std::pow(largest_rad, 2 * power + 3);
    return k;
}

}  // namespace

LensForm all_free(LensModel model) { return {model, {}}; }

LensForm with_principal_point_held(LensModel model) {
    const int first = has_one_focal_length(model) ? 1 : 2;
    return {model, {first, first + 1}};
}

LensForm focal_length_alone(LensModel model) {
    LensForm form = all_held(model);
    form.held.erase(form.held.begin(), form.held.begin() + (has_one_focal_length(model) ? 1 : 2));
    return form;
}

LensForm all_held(LensModel model) {
    LensForm form{model, std::vector<int>(parameter_count(model))};
    std::iota(form.held.begin(), form.held.end(), 0);
    return form;
}

int free_parameters(const LensForm& form) {
    return static_cast<int>(parameter_count(form.model) - form.held.size());
}

bool is_held(const LensForm& form, int parameter) {
    return std::binary_search(form.held.begin(), form.held.end(), parameter);
}

bool holds_principal_point(const LensForm& form) {
    const std::vector<int> place = with_principal_point_held(form.model).held;
    return std::all_of(place.begin(), place.end(), [&](int index) { return is_held(form, index); });
}

std::vector<std::string> parameter_names(LensModel model) {
    switch (model) {
        case LensModel::kSimplePinhole:
            return {"f", "cx", "cy"};
        case LensModel::kPinhole:
            return {"fx", "fy", "cx", "cy"};
        case LensModel::kSimpleRadial:
            return {"f", "cx", "cy", "k1"};
        case LensModel::kRadial:
            return {"f", "cx", "cy", "k1", "k2"};
        case LensModel::kOpenCv:
            return {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2"};
        case LensModel::kOpenCvFisheye:
            return {"fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4"};
        case LensModel::kFullOpenCv:
            return {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
    }
    return {};
}

std::optional<int> parameter_named(LensModel model, const std::string& name) {
    const std::vector<std::string> names = parameter_names(model);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<int>(found - names.begin());
}

std::string text_of(const LensForm& form) {
    std::string text(name_of(form.model));
    if (form.held.empty()) return text;
    if (free_parameters(form) == 0) return text + ", all held";
    const std::vector<std::string> names = parameter_names(form.model);
    text += ",";
    for (const int index : form.held) text += " " + names[static_cast<std::size_t>(index)];
    return text + " held";
}

bool is_nested_in(LensModel simpler, LensModel richer) {
    if (simpler == richer) return true;
    if (simpler == LensModel::kOpenCvFisheye || richer == LensModel::kOpenCvFisheye) return false;
    // Of two models of one family, one is nested in the other when it has no term more; PINHOLE has
    // a second focal length, which the models with one cannot follow.
    if (!has_one_focal_length(simpler) && has_one_focal_length(richer)) return false;
    return parameter_count(simpler) < parameter_count(richer);
}

Camera in_model(const Camera& lens, LensModel model) {
    if (lens.model == model) return lens;
    Camera result{lens.width_px, lens.height_px, model,
                  std::vector<double>(parameter_count(model), 0.0)};
    const Eigen::Vector2d focal_px = focal_length_px(lens);
    const Eigen::Vector2d centre_px = principal_point_px(lens);
    const std::vector<std::string> names = parameter_names(model);
    for (std::size_t index = 0; index < names.size(); ++index) {
        double& value = result.parameters[index];
        const std::string& name = names[index];
        if (name == "f") {
            value = focal_px.mean();
        } else if (name == "fx" || name == "fy") {
            value = name == "fx" ? focal_px.x() : focal_px.y();
        } else if (name == "cx" || name == "cy") {
            value = name == "cx" ? centre_px.x() : centre_px.y();
        } else if (model != LensModel::kOpenCvFisheye && lens.model != LensModel::kOpenCvFisheye) {
            const std::optional<int> same = parameter_named(lens.model, name);
            if (same) value = lens.parameters[static_cast<std::size_t>(*same)];
        }
    }
    if (model == LensModel::kOpenCvFisheye) {
        const Eigen::Vector4d k = fisheye_coefficients(lens);
        std::copy_n(k.data(), 4, result.parameters.begin() + 4);
    }
    return result;
}

Camera with_focal_length_scaled(Camera lens, double factor) {
    for (std::size_t index = 0; index < principal_point_index(lens.model); ++index) {
        lens.parameters[index] *= factor;
    }
    return lens;
}

}  // namespace lumi
