#pragma once

#include <filesystem>

#include "calib/pictures/image_io.h"
#include "calib/pictures/stored_picture.h"

namespace lumi {

/// TIFF through OpenImageIO: the header is checked before anything is decoded. Throws Error
/// (E-IMAGE-TRUNCATED, E-IMAGE-TOOBIG, E-IMAGE-FORMAT).
[[nodiscard]] ImageSize tiff_size(const std::filesystem::path& path);
/// Grey or colour of any depth: floats are light, unless the file says that they are sRGB.
[[nodiscard]] StoredPicture read_stored_tiff(const std::filesystem::path& path,
                                             std::size_t max_pixels);

}  // namespace lumi
