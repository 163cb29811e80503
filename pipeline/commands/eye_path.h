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

/// The eyes that are measured along: each that the window recorded (a JSON file), at the recorded
/// size where `size` is empty; or so many in all, straight from view to view (`kViewsPath`,
/// path_through_views). Throws Error (E-JSON-READ, E-CAMERA-INVALID, E-RENDER-SIZE).
[[nodiscard]] std::vector<Eye> eye_path(const std::string& path, int frames,
                                        const std::string& size, const Lumigraph& lumigraph);

/// The eyes of a film's frames, so many a second: along a recorded path; or on a smooth way through
/// all photographs' places (`kViewsPath`, tour_through_views), so many in all or, where nothing is
/// said, for two thirds of a second from each to the next, and four seconds at least. Throws the
/// same.
[[nodiscard]] std::vector<Eye> film_path(const std::string& path, std::optional<int> frames,
                                         const std::string& size, const Lumigraph& lumigraph,
                                         double frames_per_second);

}  // namespace lumi
