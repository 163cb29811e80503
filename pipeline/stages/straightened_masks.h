#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/work/progress.h"

namespace lumi {

/// What masks are drawn over, and who goes by them.
struct MaskedPhotographs {
    std::filesystem::path mask_folder;   ///< As drawn (drawn_mask.h).
    std::filesystem::path poses_folder;  ///< Of the poses stage.
    std::vector<std::string> all_names;  ///< Of all photographs, with and without a pose.
    std::vector<std::string> held_out;   ///< These may lack a mask.
};

/// Masks are drawn over photographs as the lens bent them; the later stages see straight pictures.
/// Brings the mask of every photograph with a pose onto its straightened picture, as NAME.png in
/// `folder`; where the lens does not bend, its pixels are those drawn. Notes masks that hide
/// nothing, masks named like no photograph, and held-out photographs without one. Throws Error
/// (E-MASK-...).
void straighten_masks(const MaskedPhotographs& photographs, const std::filesystem::path& folder,
                      int threads, Progress& progress);

/// The file of one photograph's mask there.
[[nodiscard]] std::filesystem::path straightened_mask_file(const std::filesystem::path& folder,
                                                           const std::string& name);

}  // namespace lumi
