#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The word for a path from photograph to photograph.
inline constexpr const char* kViewsPath = "views";

/// As the window shows it in a frame of the size that --size says; as it is where that is empty.
/// Throws Error (E-RENDER-SIZE).
[[nodiscard]] Eye eye_of_size(const Eye& eye, const std::string& size);

/// The eyes that --path, --frames and --size ask for: of a path that the window recorded (a JSON
/// file), at the recorded size where `size` is empty, so many a second or, without that, each that
/// was recorded; or so many in all from view to view (`kViewsPath`), then of 1280x720. Throws Error
/// (E-JSON-READ, E-CAMERA-INVALID, E-RENDER-SIZE).
[[nodiscard]] std::vector<Eye> eye_path(const std::string& path, int frames,
                                        const std::string& size, const Lumigraph& lumigraph,
                                        std::optional<double> frames_per_second = std::nullopt);

}  // namespace lumi
