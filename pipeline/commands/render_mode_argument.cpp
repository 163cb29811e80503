#include "pipeline/commands/render_mode_argument.h"

#include "calib/work/error.h"

namespace lumi {

RenderMode render_mode_from(const std::string& name) {
    if (const auto mode = render_mode_named(name)) return *mode;
    throw Error(ErrorKind::kUsage, "E-RENDER-MODE", "there is no mode named " + name,
                "use perpixel or lightfield");
}

DebugPicture debug_picture_from(const std::string& name) {
    if (const auto picture = debug_picture_named(name)) return *picture;
    throw Error(ErrorKind::kUsage, "E-RENDER-DEBUG", "there is no debug picture named " + name,
                "use none, weights, faces, depth or confidence");
}

}  // namespace lumi
