#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/capture/camera.h"

namespace lumi {

/// What is estimated of a lens: a model, and which of its parameters are held where they are.
struct LensForm {
    LensModel model = LensModel::kSimplePinhole;
    std::vector<int> held;  ///< Indices into Camera::parameters, ascending.

    friend bool operator==(const LensForm&, const LensForm&) = default;
};

/// Every parameter is estimated.
[[nodiscard]] LensForm all_free(LensModel model);
/// Every parameter but the principal point.
[[nodiscard]] LensForm with_principal_point_held(LensModel model);
/// The focal length (both of them, where the model has two).
[[nodiscard]] LensForm focal_length_alone(LensModel model);
/// None: the lens is taken as it is.
[[nodiscard]] LensForm all_held(LensModel model);

[[nodiscard]] int free_parameters(const LensForm& form);
[[nodiscard]] bool is_held(const LensForm& form, int parameter);
[[nodiscard]] bool holds_principal_point(const LensForm& form);

/// "f", "cx", "cy", "k1" ... in the order of the parameters.
[[nodiscard]] std::vector<std::string> parameter_names(LensModel model);
/// Empty when the model has no parameter of this name.
[[nodiscard]] std::optional<int> parameter_named(LensModel model, const std::string& name);
/// "RADIAL", "RADIAL, cx cy held", "RADIAL, all held".
[[nodiscard]] std::string text_of(const LensForm& form);

/// True when every lens of `simpler` is exactly a lens of `richer`: SIMPLE_PINHOLE in all but
/// OPENCV_FISHEYE, PINHOLE in OPENCV, SIMPLE_RADIAL in RADIAL in OPENCV in FULL_OPENCV. A model is
/// nested in itself.
[[nodiscard]] bool is_nested_in(LensModel simpler, LensModel richer);

/// The same lens in another model: exact where its own is nested in `model`. Otherwise the start of
/// a fit: a simpler model of the same family loses the terms it lacks, and OPENCV_FISHEYE gets the
/// coefficients that follow this lens's radius best from the principal point to the farthest
/// corner (least squares over the angle).
[[nodiscard]] Camera in_model(const Camera& lens, LensModel model);

/// The same lens with `factor` times its focal length.
[[nodiscard]] Camera with_focal_length_scaled(Camera lens, double factor);

}  // namespace lumi
