#pragma once

#include <opencv2/calib3d.hpp>

namespace lumi {

/// RANSAC with local optimization (Chum, Matas, Kittler, DAGM 2003), the same in every run: errors
/// of at most `max_error`, in the unit of what is fitted, and at most so many trials.
[[nodiscard]] inline cv::UsacParams ransac_parameters(double max_error, int max_trials) {
    cv::UsacParams parameters;
    parameters.confidence = 0.9999;
    parameters.threshold = max_error;
    parameters.maxIterations = max_trials;
    parameters.isParallel = false;
    parameters.randomGeneratorState = 1;
    parameters.sampler = cv::SAMPLING_UNIFORM;
    parameters.score = cv::SCORE_METHOD_MSAC;
    parameters.loMethod = cv::LOCAL_OPTIM_INNER_AND_ITER_LO;
    parameters.loIterations = 5;
    parameters.loSampleSize = 14;
    return parameters;
}

}  // namespace lumi
