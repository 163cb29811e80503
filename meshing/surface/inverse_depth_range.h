#pragma once

namespace lumi {

/// Inverse depths between which a scene lies: far <= near, far >= 0.
struct InverseDepthRange {
    double far = 0.0;
    double near = 0.0;
};

}  // namespace lumi
