#include "calib/adjust/reprojection_cost.h"

#include <cassert>

namespace lumi {

std::unique_ptr<ceres::CostFunction> reprojection_cost(LensModel model,
                                                       const Eigen::Vector2d& seen_at) {
    switch (model) {
        case LensModel::kSimplePinhole:
            return ReprojectionCost<LensModel::kSimplePinhole>::create(seen_at);
        case LensModel::kPinhole:
            return ReprojectionCost<LensModel::kPinhole>::create(seen_at);
        case LensModel::kSimpleRadial:
            return ReprojectionCost<LensModel::kSimpleRadial>::create(seen_at);
        case LensModel::kRadial:
            return ReprojectionCost<LensModel::kRadial>::create(seen_at);
        case LensModel::kOpenCv:
            return ReprojectionCost<LensModel::kOpenCv>::create(seen_at);
        case LensModel::kOpenCvFisheye:
            return ReprojectionCost<LensModel::kOpenCvFisheye>::create(seen_at);
        case LensModel::kFullOpenCv:
            return ReprojectionCost<LensModel::kFullOpenCv>::create(seen_at);
    }
    assert(false);
    return nullptr;
}

}  // namespace lumi
