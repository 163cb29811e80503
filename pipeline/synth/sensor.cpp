#include "pipeline/synth/sensor.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "calib/capture/light_left.h"
#include "calib/capture/nearest_byte.h"
#include "pipeline/synth/hashed_random.h"
#include "pipeline/synth/read_vectors.h"

namespace lumi {
namespace {

std::vector<float> gaussian_kernel(double sigma) {
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    std::vector<float> kernel;
    double sum = 0.0;
    for (int offset = -radius; offset <= radius; ++offset) {
        sum += std::exp(-0.5 * offset * offset / (sigma * sigma));
    }
    for (int offset = -radius; offset <= radius; ++offset) {
        kernel.push_back(
            static_cast<float>(std::exp(-0.5 * offset * offset / (sigma * sigma)) / sum));
    }
    return kernel;
}

/// Along one axis; the border's pixel continues outwards.
Image<LinearColor> blurred_along(const Image<LinearColor>& light, const std::vector<float>& kernel,
                                 int step_x, int step_y) {
    const int radius = static_cast<int>(kernel.size() / 2);
    Image<LinearColor> result(light.width(), light.height(), LinearColor::Zero());
    for (int y = 0; y < light.height(); ++y) {
        for (int x = 0; x < light.width(); ++x) {
            for (int offset = -radius; offset <= radius; ++offset) {
                const int from_x = std::clamp(x + offset * step_x, 0, light.width() - 1);
                const int from_y = std::clamp(y + offset * step_y, 0, light.height() - 1);
                result(x, y) +=
                    kernel[static_cast<std::size_t>(offset + radius)] * light(from_x, from_y);
            }
        }
    }
    return result;
}

Image<LinearColor> blurred(const Image<LinearColor>& light, double sigma_px) {
    if (sigma_px == 0.0) return light;
    const std::vector<float> kernel = gaussian_kernel(sigma_px);
    return blurred_along(blurred_along(light, kernel, 1, 0), kernel, 0, 1);
}

}  // namespace

SensorOptions read_sensor_options(const ConfigSection& section) {
    SensorOptions options;
    options.noise_sigma = read_not_negative(section, "noise_sigma", options.noise_sigma);
    options.exposure_drift_stops =
        read_not_negative(section, "exposure_drift_stops", options.exposure_drift_stops);
    options.blur_sigma_px = read_not_negative(section, "blur_sigma_px", options.blur_sigma_px);
    options.light_falloff = section.number("light_falloff", options.light_falloff);
    if (options.light_falloff > 0) section.refuse("light_falloff", "a number that is 0 or less");
    return options;
}

Image<LinearColor> behind_lens(Image<LinearColor> light, const Camera& camera,
                               double light_falloff) {
    if (light_falloff == 0) return light;
    for (int y = 0; y < light.height(); ++y)
        for (int x = 0; x < light.width(); ++x)
            light(x, y) *=
                static_cast<float>(light_left(light_falloff, camera, {x + 0.5, y + 0.5}));
    return light;
}

void fade_to_grey(Image<LinearColor>& light, double contrast) {
    const LinearColor grey = LinearColor::Constant(0.2F);
    for (LinearColor& color : light.pixels())
        color = grey + static_cast<float>(contrast) * (color - grey);
}

ColorImage develop(const Image<LinearColor>& light, const SensorOptions& options,
                   std::uint64_t photograph_seed) {
    HashedRandom random(photograph_seed);
    const auto exposure =
        static_cast<float>(std::exp2(options.exposure_drift_stops * random.symmetric()));
    const Image<LinearColor> received = blurred(light, options.blur_sigma_px);
    ColorImage result(light.width(), light.height());
    for (int y = 0; y < light.height(); ++y) {
        for (int x = 0; x < light.width(); ++x) {
            Eigen::Vector3d srgb =
                255.0 * srgb_from_linear(exposure * received(x, y)).cast<double>();
            if (options.noise_sigma > 0.0) {
                for (double& channel : srgb) channel += options.noise_sigma * random.gaussian();
            }
            result(x, y) = {nearest_byte(srgb[0]), nearest_byte(srgb[1]), nearest_byte(srgb[2])};
        }
    }
    return result;
}

}  // namespace lumi
