#include "calib/adjust/silence_ceres.h"

#include <glog/logging.h>

namespace lumi {

void silence_ceres() {
    static const bool is_silent = [] {
        FLAGS_minloglevel = google::GLOG_FATAL;
        return true;
    }();
    static_cast<void>(is_silent);
}

}  // namespace lumi
