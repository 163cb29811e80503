#pragma once

#include <string>

#include "render/modes/frame.h"

namespace lumi {

/// What --mode and --debug name. Throw Error (E-RENDER-MODE, E-RENDER-DEBUG) with what is known.
[[nodiscard]] RenderMode render_mode_from(const std::string& name);
[[nodiscard]] DebugPicture debug_picture_from(const std::string& name);

}  // namespace lumi
