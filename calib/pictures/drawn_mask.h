#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// Where the mask of a photograph lies: a black and white PNG in `folder` with the photograph's
/// name, its extension followed by ".png", else replaced by it. Empty when there is none.
[[nodiscard]] std::filesystem::path mask_file_of(const std::string& name,
                                                 const std::filesystem::path& folder);

/// Throws Error (E-MASK-SHARED) where one file is the mask of two of these photographs.
void expect_own_masks(const std::vector<std::string>& names, const std::filesystem::path& folder);

/// The mask drawn for a photograph of this size, in its own raster, which has the photograph's
/// aspect ratio and any size: 255 where something counts, 0 where the drawing is darker than half
/// or transparent. Throws Error: E-MASK-MISSING (no mask of this name), E-MASK-COLOR (not grey),
/// E-MASK-SIZE (another aspect ratio), E-MASK-EMPTY (nothing counts).
[[nodiscard]] GrayImage read_drawn_mask(const std::string& name, int width_px, int height_px,
                                        const std::filesystem::path& folder);

/// The same in the raster of the photograph, none of its pixels blended.
[[nodiscard]] GrayImage drawn_mask(const std::string& name, int width_px, int height_px,
                                   const std::filesystem::path& folder);

}  // namespace lumi
