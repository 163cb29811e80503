#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "calib/capture/camera.h"

namespace lumi {

/// A lens from a TOML file: `model` (COLMAP's name), `width_px`, `height_px`, `parameters`
/// (COLMAP's order, pixels of that size, (0.5, 0.5) the centre of the top-left pixel). Throws Error
/// (E-CONFIG-..., E-CAMERA-INVALID) naming file and key.
[[nodiscard]] Camera read_lens_file(const std::filesystem::path& path);

/// The lens as canonical text that keeps every bit; "" when there is none.
[[nodiscard]] std::string lens_parameters_text(const std::optional<Camera>& lens);

}  // namespace lumi
