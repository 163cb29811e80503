#pragma once

#include <string>

#include "render/frame/frame.h"

namespace lumi {

/// "a, b or c", for help and messages.
[[nodiscard]] std::string render_mode_names();
[[nodiscard]] std::string debug_picture_names();

/// What --mode and --debug name. Throw Error (E-RENDER-MODE, E-RENDER-DEBUG) with what is known.
[[nodiscard]] RenderMode render_mode_from(const std::string& name);
[[nodiscard]] DebugPicture debug_picture_from(const std::string& name);

}  // namespace lumi
