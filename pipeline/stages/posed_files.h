#pragma once

#include <filesystem>

#include "calib/capture/posed_photographs.h"

namespace lumi {

/// The pinhole capture that the poses stage hands on: a COLMAP model in `pinhole_folder` and
/// pictures.json, which says where each view's picture lies relative to that folder (so that both
/// may be moved together).
void write_posed_photographs(const std::filesystem::path& pinhole_folder,
                             const PosedPhotographs& photographs);
/// Throws Error (E-JSON-READ, E-COLMAP-MODEL).
[[nodiscard]] PosedPhotographs read_posed_photographs(const std::filesystem::path& pinhole_folder);

}  // namespace lumi
