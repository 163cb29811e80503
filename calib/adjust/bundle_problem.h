#pragma once

#include <ceres/ceres.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "calib/adjust/bundle_adjustment.h"
#include "calib/capture/capture.h"

namespace lumi {

/// The parameters of all lenses, one after another. Ceres orders parameter blocks by address: in
/// one piece of memory the order, and with it every rounding, is the same in every run. (Views and
/// points lie in one piece each already.)
class LensBlocks {
 public:
    explicit LensBlocks(const Capture& capture) {
        for (const Camera& camera : capture.cameras) {
            offsets_.push_back(values_.size());
            values_.insert(values_.end(), camera.parameters.begin(), camera.parameters.end());
        }
    }
    [[nodiscard]] double* of(int camera_index) {
        return values_.data() + offsets_[static_cast<std::size_t>(camera_index)];
    }
    void copy_to(Capture& capture) const {
        for (std::size_t index = 0; index < offsets_.size(); ++index) {
            std::vector<double>& parameters = capture.cameras[index].parameters;
            const auto begin = values_.begin() + static_cast<std::ptrdiff_t>(offsets_[index]);
            std::copy_n(begin, parameters.size(), parameters.begin());
        }
    }

 private:
    std::vector<double> values_;
    std::vector<std::size_t> offsets_;
};

/// The indices of a lens's parameters that stay as they are, ascending.
[[nodiscard]] std::vector<int> constant_lens_parameters(const Capture& capture,
                                                        std::size_t camera_index,
                                                        const BundleAdjustmentOptions& options);

/// Adds every observation, the manifolds of rotations, what of the lenses is held, and the gauge.
/// The problem refers to `capture` and `lenses`, which must not move.
void build_bundle_problem(ceres::Problem& problem, Capture& capture, LensBlocks& lenses,
                          const BundleAdjustmentOptions& options, ceres::LossFunction* loss);

/// Points first (the elimination order that makes the Schur complement sparse), then poses, then
/// lenses.
[[nodiscard]] std::shared_ptr<ceres::ParameterBlockOrdering> elimination_order(
    const ceres::Problem& problem, Capture& capture);

}  // namespace lumi
