#pragma once

#include <algorithm>

#include "calib/capture/image.h"

namespace lumi {

/// Puts a picture on a canvas, which must hold it there.
inline void paste(ColorImage& canvas, const ColorImage& picture, int left, int top = 0) {
    for (int y = 0; y < picture.height(); ++y)
        std::copy_n(picture.row(y), picture.width(), canvas.row(top + y) + left);
}

}  // namespace lumi
