#include "render/viewer/black_picture.h"

#include "render/bench/occlusion_share.h"

namespace lumi {

std::string why_black(const Lumigraph& lumigraph, const RenderOptions& options) {
    const DebugPicture picture = options.debug_picture;
    const bool is_of_depth =
        picture == DebugPicture::kOcclusion || picture == DebugPicture::kConfidence;
    // What occlusion is found by is depth, and how sure that is.
    if (!is_of_depth || corrects_occlusion(lumigraph, options)) return {};
    const RenderMode mode = possible_options(options, lumigraph.has_depth()).mode;
    return name_of(mode) + " knows no " + name_of(picture) + ": the picture is black";
}

}  // namespace lumi
