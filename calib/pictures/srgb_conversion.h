#pragma once

#include "calib/pictures/image_io.h"
#include "calib/pictures/stored_picture.h"

namespace lumi {

/// The picture in 8-bit sRGB. An embedded profile counts before whatever else the file says, then
/// coded colours; what is damaged, or of other numbers than the picture's, is passed over. Inks
/// without a profile are taken for ideal ones.
[[nodiscard]] SrgbPicture srgb_of(StoredPicture stored);

}  // namespace lumi
