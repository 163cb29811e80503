#include "pipeline/evaluate/heat_map.h"

#include <algorithm>
#include <cmath>

#include "pipeline/stages/color_scale.h"

namespace lumi {

ColorImage heat_map(const FloatImage& values, float full_scale) {
    ColorImage picture(values.width(), values.height());
    std::transform(values.pixels().begin(), values.pixels().end(), picture.pixels().begin(),
                   [&](float value) { return color_of_share(value / full_scale); });
    return picture;
}

FloatImage square_root(const FloatImage& values) {
    FloatImage roots(values.width(), values.height());
    std::transform(values.pixels().begin(), values.pixels().end(), roots.pixels().begin(),
                   [](float value) { return std::sqrt(value); });
    return roots;
}

}  // namespace lumi
