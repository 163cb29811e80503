#include "pipeline/commands/focus.h"

#include "calib/work/error.h"
#include "pipeline/commands/known_photographs.h"

namespace lumi {
namespace {

void check_aperture(const DrawingRequest& request, const DrawnAlike& eye_file,
                    const RenderOptions& options) {
    if (options.mode != RenderMode::kLightField)
        throw Error(ErrorKind::kUsage, "E-RENDER-FOCAL",
                    name_of(options.mode) + " blends three photographs, and has no --aperture",
                    "leave it out, or use --mode lightfield");
    if (options.debug_picture != DebugPicture::kNone)
        throw Error(ErrorKind::kUsage, "E-RENDER-FOCAL",
                    "there is no debug picture '" + name_of(options.debug_picture) +
                        "', which the file of --eye asks for, through an --aperture",
                    "leave one of them out");
    if (fade_of(request, eye_file).value_or(false))
        throw Error(ErrorKind::kUsage, "E-RENDER-FOCAL",
                    "nothing fades beyond the capture, which the file of --eye asks for, through "
                    "an --aperture",
                    "leave one of them out, or add --no-fade");
}

}  // namespace

void check_focus(const DrawingRequest& request, const DrawnAlike& eye_file,
                 const RenderOptions& options) {
    if (request.aperture > 0) check_aperture(request, eye_file, options);
    if (request.focal_depth == 0 || options.mode == RenderMode::kLightField ||
        options.mode == RenderMode::kHeigl)
        return;
    throw Error(ErrorKind::kUsage, "E-RENDER-FOCAL",
                name_of(options.mode) + " knows how far the scene is, and needs no --focal-depth",
                "leave it out, or use --mode lightfield");
}

FocalPlane focal_plane_of(const DrawingRequest& request, const std::filesystem::path& package,
                          const Lumigraph& lumigraph) {
    FocalPlane plane{.depth = request.focal_depth};
    if (!request.focal_view.empty())
        plane.cam_from_world =
            photograph_named(request.focal_view, package, lumigraph).eye.cam_from_world;
    return plane;
}

}  // namespace lumi
