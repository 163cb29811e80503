#include "pipeline/commands/eye_path.h"

#include "pipeline/commands/eye_file.h"
#include "pipeline/commands/frame_size.h"
#include "render/paths/path_through_views.h"
#include "render/viewer/photograph_eye.h"

namespace lumi {
namespace {

constexpr FrameSize kSizeOfViewsPath{1280, 720};

}  // namespace

Eye eye_of_size(const Eye& eye, const std::string& size) {
    if (size.empty()) return eye;
    const FrameSize frame_size = frame_size_from(size);
    return fitted_to(eye, frame_size.width_px, frame_size.height_px);
}

std::vector<Eye> eye_path(const std::string& path, int frames, const std::string& size,
                          const Lumigraph& lumigraph) {
    if (path != kViewsPath) {
        std::vector<Eye> eyes = read_path_file(path);
        for (Eye& eye : eyes) eye = eye_of_size(eye, size);
        return eyes;
    }
    const FrameSize frame = size.empty() ? kSizeOfViewsPath : frame_size_from(size);
    return path_through_views(lumigraph, frames, frame.width_px, frame.height_px);
}

}  // namespace lumi
