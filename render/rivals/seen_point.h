#pragma once

#include <optional>

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// A point of the scene as one view sees it.
struct SeenPoint {
    const LumigraphView* view = nullptr;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    double depth = 0.0;      ///< Of the point.
    double map_depth = 0.0;  ///< Of what the view sees there.

    [[nodiscard]] Eigen::Vector3d color() const;  ///< 0 to 255.
    [[nodiscard]] double depth_difference_share() const;
};

/// Empty when the point lies behind the view or outside of its photograph. The view has depth.
[[nodiscard]] std::optional<SeenPoint> seen_point(const LumigraphView& view,
                                                  const Eigen::Vector3d& point_in_world);

/// Covered, with a colour from 0 to 255.
void set_pixel(Frame& frame, int x, int y, const Eigen::Vector3d& color);

}  // namespace lumi
