#include "pipeline/commands/stereo_pair.h"

#include <algorithm>

#include "render/transfer/scene_plane.h"

namespace lumi {
namespace {

/// Of the scene's plane in the middle of the picture; 0 where that does not meet it.
double middle_inverse_depth(const Lumigraph& lumigraph, const Eye& eye) {
    const Eigen::Vector3d middle_px(0.5 * eye.camera.width_px, 0.5 * eye.camera.height_px, 1);
    return std::max(0.0, scene_plane_inverse_depth(lumigraph, eye).dot(middle_px));
}

/// The eye moved along its own x axis, and its picture shifted so that what stands at this inverse
/// depth stays where it is.
Eye moved_right(const Eye& eye, double distance, double inverse_depth) {
    Eye moved = eye;
    moved.cam_from_world.translation.x() -= distance;
    const double focal_length_px = eye.camera.parameters[0];
    moved.camera.parameters[2] += focal_length_px * distance * inverse_depth;
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

ColorImage picture_of(const Lumigraph& lumigraph, const Eye& eye, double stereo_baseline,
                      const Draw& draw) {
    if (stereo_baseline <= 0) return draw(eye).color;
    const double inverse_depth = middle_inverse_depth(lumigraph, eye);
    const auto seen_from = [&](double distance) {
        return draw(moved_right(eye, distance, inverse_depth)).color;
    };
    const ColorImage left = seen_from(-0.5 * stereo_baseline);
    return side_by_side(left, seen_from(0.5 * stereo_baseline));
}

}  // namespace lumi
