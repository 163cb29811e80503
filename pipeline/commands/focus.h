#pragma once

#include <filesystem>

#include "pipeline/commands/drawing_request.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Throws Error (E-RENDER-FOCAL) where nothing would come of the focal depth or the aperture that
/// are asked for: the mode has no use for them, or the eye's file asks for what no aperture draws.
/// `options` are as they are drawn (possible_options): of a package without depth most modes come
/// to the light field, which has a use for both.
void check_focus(const DrawingRequest& request, const DrawnAlike& eye_file,
                 const RenderOptions& options);

/// The plane that is sharp, if one is asked for. It may stand before a photograph of the package or
/// one that was held out from it; throws what photograph_named does.
[[nodiscard]] FocalPlane focal_plane_of(const DrawingRequest& request,
                                        const std::filesystem::path& package,
                                        const Lumigraph& lumigraph);

}  // namespace lumi
