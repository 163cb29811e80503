#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "pipeline/commands/commands.h"
#include "pipeline/commands/render_request.h"
#include "pipeline/commands/stereo_pair.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The mode, or the rival's name, as frames and their records are named.
[[nodiscard]] std::string method_of(const RenderRequest& request, const RenderOptions& options);

/// Draws what was asked for and writes it: the eye of a file, a photograph's place, all of them, or
/// a path as a folder of frames or a video. Says each frame that was written; returns a record of
/// each: its file, the time that it took, and how far it is from the photograph where that was
/// asked. Throws Error, and what `draw` throws.
[[nodiscard]] nlohmann::ordered_json draw_requested(const RenderRequest& request, const Eye& eye,
                                                    const RenderOptions& options,
                                                    const Lumigraph& lumigraph, const Draw& draw,
                                                    const CommandContext& context);

}  // namespace lumi
