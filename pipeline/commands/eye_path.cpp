#include "pipeline/commands/eye_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/commands/eye_file.h"
#include "pipeline/commands/frame_size.h"
#include "render/paths/path_through_views.h"
#include "render/paths/photograph_eye.h"
#include "render/paths/tour_through_views.h"

namespace lumi {
namespace {

constexpr double kSecondsBetweenPhotographs = 2.0 / 3;
constexpr double kShortestTour_s = 4.0;

std::vector<Eye> of_size(std::vector<Eye> eyes, const std::string& size) {
    for (Eye& eye : eyes) eye = eye_of_size(eye, size);
    return eyes;
}

/// The first photograph's where nothing is said.
FrameSize size_of_frames(const std::string& size, const Lumigraph& lumigraph) {
    if (!size.empty()) return frame_size_from(size);
    const Camera first = eye_at(lumigraph.views.front()).camera;
    return {first.width_px, first.height_px};
}

int frames_of_tour(const Lumigraph& lumigraph, double frames_per_second) {
    const auto steps = static_cast<double>(lumigraph.views.size() - 1);
    const double seconds = std::max(kShortestTour_s, kSecondsBetweenPhotographs * steps);
    return static_cast<int>(std::lround(seconds * frames_per_second));
}

}  // namespace

Eye eye_of_size(const Eye& eye, const std::string& size) {
    if (size.empty()) return eye;
    const FrameSize frame_size = frame_size_from(size);
    return fitted_to(eye, frame_size.width_px, frame_size.height_px);
}

std::vector<Eye> eye_path(const std::string& path, int frames, const std::string& size,
                          const Lumigraph& lumigraph) {
    if (path == kViewsPath) {
        const FrameSize frame = size_of_frames(size, lumigraph);
        return path_through_views(lumigraph, frames, frame.width_px, frame.height_px);
    }
    std::vector<Eye> eyes;
    for (const TimedEye& timed : read_path_file(path, 1.0)) eyes.push_back(timed.eye);
    return of_size(std::move(eyes), size);
}

std::vector<Eye> film_path(const std::string& path, std::optional<int> frames,
                           const std::string& size, const Lumigraph& lumigraph,
                           double frames_per_second) {
    if (path == kViewsPath) {
        const FrameSize frame = size_of_frames(size, lumigraph);
        return tour_through_views(lumigraph,
                                  frames.value_or(frames_of_tour(lumigraph, frames_per_second)),
                                  frame.width_px, frame.height_px);
    }
    return of_size(eyes_at_even_times(read_path_file(path, frames_per_second), frames_per_second),
                   size);
}

}  // namespace lumi
