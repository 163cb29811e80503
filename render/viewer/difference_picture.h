#pragma once

#include "calib/capture/image.h"

namespace lumi {

/// Each channel of |drawn - photograph|, four times as bright; both of one size.
[[nodiscard]] ColorImage difference_picture(const ColorImage& drawn, const ColorImage& photograph);

}  // namespace lumi
