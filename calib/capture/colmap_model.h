#pragma once

#include <filesystem>

#include "calib/capture/capture.h"

namespace lumi {

/// Reads a COLMAP model (cameras, images, points3D) from a folder, binary or text, whichever is
/// there (binary first, as COLMAP does).
///
/// Trusts nothing: sizes are compared with counts before memory is taken, numbers must be finite,
/// ids must exist, names with spaces are kept. Throws Error (E-COLMAP-MODEL; E-COLMAP-LENS where a
/// lens is one that lumi lacks) with file and line or offset. Reference:
/// colmap.github.io/format.html.
[[nodiscard]] Capture read_colmap_model(const std::filesystem::path& folder);

/// Writes a model that COLMAP 3.8 reads back. Camera ids are index + 1, image ids are view index +
/// 1 and point ids are point index + 1. The text form keeps every bit of a double and refuses names
/// that it cannot carry (E-COLMAP-NAME).
void write_colmap_model_binary(const Capture& capture, const std::filesystem::path& folder);
void write_colmap_model_text(const Capture& capture, const std::filesystem::path& folder);

}  // namespace lumi
