#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/features/features.h"

namespace lumi {

struct PhotographSimilarityOptions {
    int words = 64;      ///< Of the vocabulary. > 0.
    int features = 600;  ///< The largest of each photograph. > 0.
    int rounds = 6;      ///< Of k-means. > 0.
};

/// How alike photographs look as a whole: the cosines between their VLAD descriptors (Jégou et al.,
/// CVPR 2010), with each word's residuals normalized (Arandjelović and Zisserman, CVPR 2013). The
/// vocabulary is made of the photographs' own features by k-means, in a fixed order: the same in
/// every run. Square, symmetric, in [-1, 1]; 0 with photographs that have no features.
[[nodiscard]] Eigen::MatrixXf photograph_similarity(const std::vector<Features>& photographs,
                                                    const PhotographSimilarityOptions& options);

}  // namespace lumi
