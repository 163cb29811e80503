#include "calib/pictures/srgb_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lumi {

double light_of_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

const std::array<float, 256>& light_of_srgb_bytes() {
    static const std::array<float, 256> kLight = [] {
        std::array<float, 256> light{};
        for (std::size_t i = 0; i < light.size(); ++i) {
            light[i] = static_cast<float>(light_of_srgb(static_cast<double>(i) / 255.0));
        }
        return light;
    }();
    return kLight;
}

double srgb_of_light(double light) {
    const double clamped = std::clamp(light, 0.0, 1.0);
    return clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1.0 / 2.4) - 0.055;
}

}  // namespace lumi
