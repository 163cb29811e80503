#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "calib/lens/lens_form.h"

namespace lumi {

/// What is left of a lens when the parameters go that measurement cannot tell from nothing.
struct SupportedLens {
    LensForm form;                     ///< The simplest model that has what is left.
    Camera start;                      ///< The lens in that model: where a last fit may start.
    std::vector<std::string> dropped;  ///< "k2 = -0.0031 +- 0.0024", as they went.
};

/// Holds every parameter that lies within two standard deviations of its neutral value: distortion
/// of 0, a principal point in the middle of the picture, fy = fx. One at a time, the least certain
/// first, and the others follow along `covariance` (of all parameters; zero rows where `form` holds
/// them): of two that say the same, one stays. A principal point goes as a whole or not at all,
/// because its axes are those of the sensor and not of the lens; the focal length always stays.
/// Then the model becomes the simplest that can express the rest.
[[nodiscard]] SupportedLens supported_lens(const Camera& lens, const LensForm& form,
                                           const Eigen::MatrixXd& covariance);

}  // namespace lumi
