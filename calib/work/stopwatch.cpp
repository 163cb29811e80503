#include "calib/work/stopwatch.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>

#include "calib/work/cpu_time.h"

namespace lumi {
namespace {

double wall_now_s() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

rusage usage_of(int who) {
    rusage usage{};
    getrusage(who, &usage);
    return usage;
}

}  // namespace

Stopwatch::Stopwatch()
    : wall_start_s_(wall_now_s()),
      cpu_start_s_(cpu_s_of(usage_of(RUSAGE_SELF)) + cpu_s_of(usage_of(RUSAGE_CHILDREN))) {}

Cost Stopwatch::elapsed() const {
    const rusage self = usage_of(RUSAGE_SELF);
    const rusage children = usage_of(RUSAGE_CHILDREN);
    Cost cost;
    cost.wall_s = wall_now_s() - wall_start_s_;
    cost.cpu_s = cpu_s_of(self) + cpu_s_of(children) - cpu_start_s_;
    cost.peak_mib = static_cast<double>(std::max(self.ru_maxrss, children.ru_maxrss)) / 1024.0;
    return cost;
}

}  // namespace lumi
