#include "render/paths/timed_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "render/paths/pose_between.h"

namespace lumi {
namespace {

Eye eye_between(const Eye& from, const Eye& to, double share) {
    Eye eye{to.camera, pose_between(from.cam_from_world, to.cam_from_world, share)};
    for (std::size_t i = 0; i < eye.camera.parameters.size(); ++i)
        eye.camera.parameters[i] =
            std::lerp(from.camera.parameters[i], to.camera.parameters[i], share);
    return eye;
}

}  // namespace

Eye eye_at_time(std::span<const TimedEye> path, double time_s) {
    const auto next = std::ranges::lower_bound(path, time_s, {}, &TimedEye::time_s);
    if (next == path.end()) return path.back().eye;
    // To the last bit where an eye was recorded.
    if (next == path.begin() || next->time_s == time_s) return next->eye;
    const TimedEye& last = *std::prev(next);
    return eye_between(last.eye, next->eye, (time_s - last.time_s) / (next->time_s - last.time_s));
}

std::vector<Eye> eyes_at_even_times(std::span<const TimedEye> path, double eyes_per_second) {
    // The last eye's time is rounded as all are.
    constexpr double kRounding = 1e-6;
    const double last = std::floor(path.back().time_s * eyes_per_second + kRounding);
    std::vector<Eye> eyes;
    for (double i = 0; i <= last; ++i) eyes.push_back(eye_at_time(path, i / eyes_per_second));
    return eyes;
}

}  // namespace lumi
