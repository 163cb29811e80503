#pragma once

#include <algorithm>
#include <string>

#include "calib/capture/capture.h"
#include "calib/capture/image.h"

namespace lumi {

/// What belongs to a photograph as the lens bent it, brought onto its straightened picture: at each
/// pixel of the pinhole camera the nearest sample to where the lens has it, none blended; Pixel{}
/// where it has nothing. The raster may be of another size than the photograph.
template <class Pixel>
[[nodiscard]] Image<Pixel> straightened(const Image<Pixel>& raster, const Camera& lens,
                                        const Camera& pinhole) {
    Image<Pixel> straight(pinhole.width_px, pinhole.height_px);
    const double scale_x = static_cast<double>(raster.width()) / lens.width_px;
    const double scale_y = static_cast<double>(raster.height()) / lens.height_px;
    for (int y = 0; y < straight.height(); ++y) {
        for (int x = 0; x < straight.width(); ++x) {
            Eigen::Vector2d pixel(x + 0.5, y + 0.5);
            if (!is_pinhole(lens)) {
                const auto bent = project(lens, unproject(pinhole, pixel));
                if (!bent) continue;
                pixel = *bent;
            }
            const auto raster_x = static_cast<int>(std::clamp(pixel.x() * scale_x, 0.0, 1e9));
            const auto raster_y = static_cast<int>(std::clamp(pixel.y() * scale_y, 0.0, 1e9));
            straight(x, y) = raster(std::min(raster_x, raster.width() - 1),
                                    std::min(raster_y, raster.height() - 1));
        }
    }
    return straight;
}

/// The camera of the view of that name, which must be there.
[[nodiscard]] inline const Camera& camera_of_view(const Capture& capture, const std::string& name) {
    const auto view = std::find_if(capture.views.begin(), capture.views.end(),
                                   [&](const View& other) { return other.name == name; });
    return camera_of(capture, *view);
}

}  // namespace lumi
