#pragma once

#include <optional>
#include <vector>

namespace lumi {

/// y = factor * x^exponent.
struct PowerLaw {
    double exponent = 0.0;
    double factor = 0.0;
    double exponent_error = 0.0;  ///< Standard error; 0 for two points.
};

/// The power law through positive points by least squares of the logarithms; other points are left
/// out. Empty when fewer than two different x are left.
[[nodiscard]] std::optional<PowerLaw> fit_power_law(const std::vector<double>& x,
                                                    const std::vector<double>& y);

}  // namespace lumi
