#pragma once

#include "calib/work/progress.h"

namespace lumi {

/// While it lives, SIGINT and SIGTERM ask the work behind `progress` to stop; a second signal ends
/// the process at once. At most one at a time.
class Interruption {
 public:
    explicit Interruption(Progress& progress);
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
};

}  // namespace lumi
