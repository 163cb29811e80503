#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/capture/image.h"
#include "calib/ingest/ingest.h"

namespace lumi {

/// Photographs that an alpha channel cuts out say themselves what belongs to the scene. Beside the
/// working copies lie masks of it, as if they had been drawn (drawn_mask.h): NAME.png, black where
/// a photograph is wholly transparent.

/// Keeps the mask of one photograph, in the raster of its file.
void write_cut_out(const std::string& name, const GrayImage& shown,
                   const std::filesystem::path& copies_folder);

/// Where photographs are cut out, gives the others masks, all white. Masks of what is not among
/// them are removed; and all of them, where photographs of one size hide the same (nine tenths of
/// what any of them hides), and no more than three tenths of the picture, none of it in the middle
/// half: what straightening a lens left along the rim is no outline of a subject. Where most
/// photographs have a size of their own, it must lie along the rim of each: of what is farther from
/// it than a tenth of a side it may hide no more than a hundredth.
void complete_cut_outs(const std::vector<Photograph>& photographs,
                       const std::filesystem::path& copies_folder);

/// Removes the masks of an earlier run.
void clear_cut_outs(const std::filesystem::path& copies_folder);

/// The folder of these masks; empty when there are none.
[[nodiscard]] std::filesystem::path cut_out_folder(const std::filesystem::path& copies_folder);

}  // namespace lumi
