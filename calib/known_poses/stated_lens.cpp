#include "calib/known_poses/stated_lens.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lumi {
namespace {

std::optional<double> focal_length_px_of(const std::optional<double>& focal_px,
                                         const std::optional<double>& angle_of_view_rad,
                                         int side_px) {
    if (focal_px || !angle_of_view_rad) return focal_px;
    return 0.5 * side_px / std::tan(0.5 * *angle_of_view_rad);
}

bool is_zero(double term) { return term == 0; }

/// The model and how many terms it takes.
std::pair<LensModel, std::size_t> model_of(const StatedLens& lens) {
    const auto& terms = lens.distortion;
    if (lens.is_fisheye) return {LensModel::kOpenCvFisheye, 4};
    if (terms.back() != 0) return {LensModel::kFullOpenCv, 5};
    if (!std::all_of(terms.begin(), terms.end(), is_zero)) return {LensModel::kOpenCv, 4};
    return {LensModel::kPinhole, 0};
}

}  // namespace

Camera lens_for_size(const StatedLens& lens, int width_px, int height_px) {
    const auto focal_x = focal_length_px_of(lens.focal_x_px, lens.angle_of_view_x_rad, width_px);
    const auto focal_y = focal_length_px_of(lens.focal_y_px, lens.angle_of_view_y_rad, height_px);
    const auto [model, terms] = model_of(lens);
    Camera camera{width_px, height_px, model, {}};
    camera.parameters = {focal_x ? *focal_x : focal_y.value(), focal_y ? *focal_y : focal_x.value(),
                         lens.centre_x_px.value_or(0.5 * width_px),
                         lens.centre_y_px.value_or(0.5 * height_px)};
    camera.parameters.insert(camera.parameters.end(), lens.distortion.begin(),
                             lens.distortion.begin() + static_cast<std::ptrdiff_t>(terms));
    camera.parameters.resize(parameter_count(model));
    return camera;
}

}  // namespace lumi
