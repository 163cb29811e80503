#include "pipeline/commands/stereo_pair.h"

#include <algorithm>

namespace lumi {
namespace {

/// The eye moved along its own x axis.
Eye moved_right(const Eye& eye, double distance) {
    Eye moved = eye;
    moved.cam_from_world.translation.x() -= distance;
    return moved;
}

ColorImage side_by_side(const ColorImage& left, const ColorImage& right) {
    ColorImage both(left.width() + right.width(), left.height());
    for (int y = 0; y < left.height(); ++y) {
        std::copy_n(left.row(y), left.width(), both.row(y));
        std::copy_n(right.row(y), right.width(), both.row(y) + left.width());
    }
    return both;
}

}  // namespace

ColorImage picture_of(const Eye& eye, double stereo_baseline, const Draw& draw) {
    if (stereo_baseline <= 0) return draw(eye).color;
    return side_by_side(draw(moved_right(eye, -0.5 * stereo_baseline)).color,
                        draw(moved_right(eye, 0.5 * stereo_baseline)).color);
}

}  // namespace lumi
