#pragma once

#include <string>

#include "render/frame/frame.h"
#include "render/rivals/rival_methods.h"

namespace lumi {

/// "a, b or c", for help and messages.
[[nodiscard]] std::string render_mode_names();
[[nodiscard]] std::string debug_picture_names();
/// Methods of others (render/rivals/rival_methods.h), with hyphens between their words; those in
/// plain code first.
[[nodiscard]] std::string rival_names();

/// One of the two.
struct RivalChoice {
    const PlainRival* plain = nullptr;
    const ResampledRival* resampled = nullptr;
};

/// What --mode, --debug and --rival name. Throw Error (E-RENDER-MODE, E-RENDER-DEBUG,
/// E-RENDER-RIVAL) with what is known.
[[nodiscard]] RenderMode render_mode_from(const std::string& name);
[[nodiscard]] DebugPicture debug_picture_from(const std::string& name);
[[nodiscard]] RivalChoice rival_named(const std::string& name);

}  // namespace lumi
