#pragma once

#include <sys/resource.h>

namespace lumi {

/// User and system time.
[[nodiscard]] inline double cpu_s_of(const rusage& usage) {
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace lumi
