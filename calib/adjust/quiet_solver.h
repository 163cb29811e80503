#pragma once

#include <ceres/solver.h>

#include "calib/adjust/silence_ceres.h"

namespace lumi {

/// Ceres' own settings, for a solver that says nothing (silence_ceres) and works on one thread, so
/// that the result is the same to the bit.
[[nodiscard]] inline ceres::Solver::Options quiet_solver_options() {
    silence_ceres();
    ceres::Solver::Options options;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    return options;
}

}  // namespace lumi
