#include "pipeline/chart/power_law.h"

#include <cassert>
#include <cmath>

namespace lumi {

std::optional<PowerLaw> fit_power_law(const std::vector<double>& x, const std::vector<double>& y) {
    assert(x.size() == y.size());
    std::vector<double> log_x;
    std::vector<double> log_y;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!(x[i] > 0.0) || !(y[i] > 0.0)) continue;
        log_x.push_back(std::log(x[i]));
        log_y.push_back(std::log(y[i]));
    }
    const auto count = static_cast<double>(log_x.size());
    if (count < 2.0) return std::nullopt;
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (std::size_t i = 0; i < log_x.size(); ++i) {
        mean_x += log_x[i] / count;
        mean_y += log_y[i] / count;
    }
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t i = 0; i < log_x.size(); ++i) {
        xx += (log_x[i] - mean_x) * (log_x[i] - mean_x);
        xy += (log_x[i] - mean_x) * (log_y[i] - mean_y);
    }
    if (xx < 1e-12) return std::nullopt;
    PowerLaw law{xy / xx, std::exp(mean_y - xy / xx * mean_x), 0.0};
    if (count > 2.0) {
        double squares = 0.0;
        for (std::size_t i = 0; i < log_x.size(); ++i) {
            const double rest = log_y[i] - mean_y - law.exponent * (log_x[i] - mean_x);
            squares += rest * rest;
        }
        law.exponent_error = std::sqrt(squares / (count - 2.0) / xx);
    }
    return law;
}

}  // namespace lumi
