#pragma once

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "calib/capture/rigid3.h"
#include "calib/work/config_section.h"
#include "pipeline/synth/scene.h"

namespace lumi {

/// How finely a picture is sampled.
struct SamplingOptions {
    /// A pixel that shows one surface is the mean of this many samples squared of its texture. > 0.
    int samples_per_texture = 2;
    /// A pixel that borders on another surface is the mean of this many rays squared. > 0.
    int samples_per_edge = 3;
};

[[nodiscard]] SamplingOptions read_sampling_options(const ConfigSection& section);

/// What an ideal sensor receives, and how far the scene is.
struct ExactPicture {
    Image<LinearColor> light;  ///< The mean over each pixel; black where there is nothing.
    FloatImage depth;          ///< z at the centres of the pixels, world units; 0: nothing there.
};

/// The ray through a pixel's place, and how much of z one unit along it is.
struct PixelRay {
    Ray ray;
    double depth_per_distance = 1.0;
};
[[nodiscard]] PixelRay ray_through(const Camera& camera, const Rigid3& world_from_cam,
                                   const Eigen::Vector2d& pixel);

/// A picture without noise; lens distortion is the camera's. The same bytes on every run.
[[nodiscard]] ExactPicture photograph(const Scene& scene, const Camera& camera,
                                      const Rigid3& cam_from_world, const SamplingOptions& options);

}  // namespace lumi
