#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "calib/pictures/image_format.h"

namespace lumi {

/// What a camera wrote beside the raster; absent where it wrote nothing sensible.
struct ExifFacts {
    int orientation = 1;  ///< 1 to 8.
    std::string make;
    std::string model;
    std::optional<double> focal_length_mm;
    std::optional<double> focal_length_35mm_equivalent_mm;
    std::optional<double> focal_plane_pixels_per_mm;  ///< For the size as shot.
    ImageSize size_as_shot;                           ///< 0x0 when not told.
};

/// Never fails: a file without readable EXIF has none.
[[nodiscard]] ExifFacts read_exif(const std::filesystem::path& path, ImageFormat format);

/// Focal length for a raster of `size`. From the 35 mm equivalent by the diagonal of that film
/// (43.27 mm; CIPA DCG-001), else from the sensor's pixel pitch where the size as shot is told,
/// else none. None as well when the raster was cropped after it was shot, or when the figure is
/// beyond any lens.
[[nodiscard]] std::optional<double> focal_length_px_of(const ExifFacts& exif, ImageSize size);

/// Equal for photographs of one camera and zoom.
[[nodiscard]] std::string camera_key_of(const ExifFacts& exif, ImageSize size);

}  // namespace lumi
