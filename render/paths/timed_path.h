#pragma once

#include <span>
#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// An eye of a path, and when it stood there.
struct TimedEye {
    double time_s = 0.0;  ///< From the beginning of the path.
    Eye eye;
};

/// Where a path of at least one eye, in the order of their times, leads at a time: between two eyes
/// the centre runs straight, and rotation and lens change evenly; before the first and after the
/// last eye it rests. Between two eyes of one time it jumps.
[[nodiscard]] Eye eye_at_time(std::span<const TimedEye> path, double time_s);

/// The eyes of such a path from time 0 to its end, so many a second.
[[nodiscard]] std::vector<Eye> eyes_at_even_times(std::span<const TimedEye> path,
                                                  double eyes_per_second);

}  // namespace lumi
