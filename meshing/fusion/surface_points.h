#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "calib/capture/image.h"
#include "calib/work/progress.h"
#include "meshing/surface/pictured_view.h"

namespace lumi {

/// A point of the scene's surface, in the world of the poses.
struct SurfacePoint {
    Eigen::Vector3d position;
    Eigen::Vector3f normal;  ///< Of length 1, towards the cameras.
    Rgb8 color;
    float spacing = 0.0F;  ///< To the next points, about; world units.
};

struct SurfacePointOptions {
    /// Cells in which pixels are averaged to one point, in pixels of the camera nearest to them.
    double spacing_px = 2.0;  ///< >= 1. Grows where there would be more points than `max_points`.
    int max_points = 250000;  ///< >= 1000.
    int min_agreeing_views = 1;  ///< Others that see the same surface; 1 to 8, the nearest ones.
};

struct SurfacePoints {
    std::vector<SurfacePoint> points;
    std::uint64_t confident_pixels = 0;  ///< That some other view agreed with when depth was found.
    std::uint64_t agreeing_pixels = 0;   ///< That became part of a point.
    double spacing_px = 0.0;             ///< As it came out.
};

/// Points from the depth of all views. A pixel counts where enough of the nearest views that have
/// parallax (parallax.h), when asked at the place that it has there, send it back to within a pixel
/// of itself, and more of them than see through it; it is put where these views have it on average.
/// Pixels that are seen at a slant of more than 80 degrees lie at the edge of something, between
/// two surfaces. What falls into one cell of a grid is averaged; cells grow with the distance to
/// the nearest camera, and faster where depth is less certain than pixels are wide, so that layers
/// of noise do not become surfaces. The same points for any number of threads. Throws Error
/// (E-FUSE-OPTION) where more views are to agree than any view has neighbours with parallax.
[[nodiscard]] SurfacePoints surface_points(const std::vector<PicturedView>& views,
                                           const SurfacePointOptions& options, int threads,
                                           Progress& progress);

}  // namespace lumi
