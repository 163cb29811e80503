#pragma once

#include <ceres/iteration_callback.h>

#include "calib/work/progress.h"

namespace lumi {

/// Ends Ceres between two iterations when the user asks. What it leaves then is no solution:
/// whoever uses this asks `throw_if_interrupted` afterwards.
class StopOnInterrupt final : public ceres::IterationCallback {
 public:
    explicit StopOnInterrupt(const Progress& progress) : progress_(progress) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
        return progress_.interrupted() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
    }

 private:
    const Progress& progress_;
};

}  // namespace lumi
