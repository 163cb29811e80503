#pragma once

#include <cstdint>

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "calib/work/config_section.h"
#include "pipeline/synth/material.h"

namespace lumi {

/// What a real camera spoils; by default nothing.
struct SensorOptions {
    double noise_sigma = 0.0;           ///< Standard deviation in 8-bit sRGB steps. >= 0.
    double exposure_drift_stops = 0.0;  ///< Largest error of a photograph's exposure. >= 0.
    double blur_sigma_px = 0.0;         ///< Gaussian blur, standard deviation. >= 0.
    double light_falloff = 0.0;         ///< Of the lens (light_left.h). <= 0.
};

[[nodiscard]] SensorOptions read_sensor_options(const ConfigSection& section);

/// What of the light such a lens lets through to its sensor.
[[nodiscard]] Image<LinearColor> behind_lens(Image<LinearColor> light, const Camera& camera,
                                             double light_falloff);

/// Leaves so much of how the light differs from an even grey.
void fade_to_grey(Image<LinearColor>& light, double contrast);

/// The photograph that a camera makes of the light: blurred, exposed, encoded as sRGB, noisy, and
/// rounded, in this order. `photograph_seed` decides exposure and noise.
[[nodiscard]] ColorImage develop(const Image<LinearColor>& light, const SensorOptions& options,
                                 std::uint64_t photograph_seed);

}  // namespace lumi
