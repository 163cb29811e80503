#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "calib/capture/rigid3.h"
#include "calib/work/progress.h"
#include "pipeline/hazards/hazard.h"

namespace lumi {

/// Photographs of which it is known what is wrong with them, and where they were taken.
struct HazardCapture {
    struct Photo {
        std::string name;
        ColorImage picture;
        Camera camera;
        Rigid3 cam_from_world;
    };
    std::vector<Photo> photos;
    std::optional<double> told_focal_length_px;  ///< As EXIF would, right or wrong.
};

/// Takes the photographs of one hazard at one strength. The same bytes for any number of threads.
[[nodiscard]] HazardCapture photograph_hazard(Hazard hazard, double strength, std::uint64_t seed,
                                              int threads, Progress& progress);

}  // namespace lumi
