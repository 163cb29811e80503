#include "pipeline/commands/eye_path.h"

#include "pipeline/commands/eye_file.h"
#include "pipeline/commands/frame_size.h"
#include "render/paths/path_through_views.h"
#include "render/paths/photograph_eye.h"

namespace lumi {
namespace {

std::vector<Eye> recorded_eyes(const std::string& file, std::optional<double> frames_per_second) {
    const std::vector<TimedEye> path = read_path_file(file, frames_per_second.value_or(1.0));
    if (frames_per_second) return eyes_at_even_times(path, *frames_per_second);
    std::vector<Eye> eyes;
    for (const TimedEye& timed : path) eyes.push_back(timed.eye);
    return eyes;
}

}  // namespace

Eye eye_of_size(const Eye& eye, const std::string& size) {
    if (size.empty()) return eye;
    const FrameSize frame_size = frame_size_from(size);
    return fitted_to(eye, frame_size.width_px, frame_size.height_px);
}

std::vector<Eye> eye_path(const std::string& path, int frames, const std::string& size,
                          const Lumigraph& lumigraph, std::optional<double> frames_per_second) {
    if (path != kViewsPath) {
        std::vector<Eye> eyes = recorded_eyes(path, frames_per_second);
        for (Eye& eye : eyes) eye = eye_of_size(eye, size);
        return eyes;
    }
    const Camera first = eye_at(lumigraph.views.front()).camera;
    const FrameSize frame =
        size.empty() ? FrameSize{first.width_px, first.height_px} : frame_size_from(size);
    return path_through_views(lumigraph, frames, frame.width_px, frame.height_px);
}

}  // namespace lumi
