#pragma once

#include "calib/capture/capture.h"

namespace lumi {

/// A cloud of points seen by cameras on an arc, with exact poses: the truth for tests.
struct SyntheticCaptureOptions {
    int views = 8;
    int points = 300;
    double noise_px = 0.0;        ///< Standard deviation of each observed coordinate.
    double outlier_share = 0.0;   ///< Observations moved by 20 to 120 pixels.
    double depth_of_cloud = 1.0;  ///< Along z, where the cloud is 2 wide and high. 0: a plane.
    double arc_radius = 4.0;      ///< Distance of the cameras from the middle of the cloud.
    double arc_deg = 60.0;
    unsigned seed = 1;
};
[[nodiscard]] Capture synthetic_capture(const Camera& camera,
                                        const SyntheticCaptureOptions& options);

}  // namespace lumi
