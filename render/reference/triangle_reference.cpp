#include "render/reference/triangle_reference.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "calib/capture/nearest_byte.h"
#include "render/depth_search/occlusion.h"
#include "render/reference/debug_color.h"
#include "render/transfer/view_geometry.h"
#include "render/uploaded/photograph_opacity.h"

namespace lumi {
namespace {

/// A pixel whose middle lies on an edge belongs to the triangle on its right, or else above: to
/// one of them, as in OpenGL, and the same one.
const Eigen::Vector3d kOffEdges_px(1e-4, -1e-5, 0);

/// One corner's share of a pixel times what it carries, summed over the corners.
template <class Value>
auto interpolated(const std::array<const BlendVertex*, 3>& corners, const Eigen::Vector3d& shares,
                  const Value& value) {
    return (shares[0] * value(*corners[0]) + shares[1] * value(*corners[1]) +
            shares[2] * value(*corners[2]))
        .eval();
}

double interpolated_number(const std::array<const BlendVertex*, 3>& corners,
                           const Eigen::Vector3d& shares, float BlendVertex::*member) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += shares[static_cast<Eigen::Index>(i)] * static_cast<double>(corners[i]->*member);
    return sum;
}

/// Where vertices know them.
void draw_surroundings(const std::array<const BlendVertex*, 3>& corners,
                       const Eigen::Vector3d& shares, int x, int y, Frame& frame) {
    const Eigen::Vector3d color = interpolated(corners, shares, [](const BlendVertex& vertex) {
        return Eigen::Vector3d(vertex.surroundings[0], vertex.surroundings[1],
                               vertex.surroundings[2]);
    });
    if (color.minCoeff() < 0) return;
    frame.color(x, y) = {nearest_byte(color.x()), nearest_byte(color.y()), nearest_byte(color.z())};
    frame.coverage(x, y) = 0;
}

}  // namespace

TriangleReference::TriangleReference(const Lumigraph& lumigraph, const Eye& eye,
                                     PlaceInterpolation places, DebugPicture debug_picture)
    : lumigraph_(lumigraph),
      photographs_(lumigraph, eye, photograph_opacities(lumigraph)),
      places_(places),
      debug_picture_(debug_picture) {}

void TriangleReference::draw(const BlendTriangles& triangles, Frame& frame) const {
    draw(triangles, false, frame);
}

void TriangleReference::lay_over(const BlendTriangles& triangles, Frame& frame) const {
    draw(triangles, true, frame);
}

void TriangleReference::draw(const BlendTriangles& triangles, bool is_laid_over,
                             Frame& frame) const {
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3)
        draw_triangle({&triangles.vertices[triangles.indices[i]],
                       &triangles.vertices[triangles.indices[i + 1]],
                       &triangles.vertices[triangles.indices[i + 2]]},
                      is_laid_over, frame);
    frame.statistics.triangles += triangles.count();
}

void TriangleReference::draw_triangle(const Corners& corners, bool is_laid_over,
                                      Frame& frame) const {
    Eigen::Matrix3d pixels;
    Eigen::Array3d inverse_depths;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const BlendVertex& corner = *corners[static_cast<std::size_t>(i)];
        pixels.col(i) = Eigen::Vector3d(corner.pixel[0], corner.pixel[1], 1);
        inverse_depths[i] = 1 / static_cast<double>(corner.depth);
    }
    if (std::abs(pixels.determinant()) < 1e-9) return;
    const Eigen::Matrix3d shares_from_pixel = pixels.inverse();
    const Eigen::Vector2d low = pixels.topRows<2>().rowwise().minCoeff();
    const Eigen::Vector2d high = pixels.topRows<2>().rowwise().maxCoeff();
    const int end_x = std::min(frame.color.width(), static_cast<int>(std::ceil(high.x())));
    const int end_y = std::min(frame.color.height(), static_cast<int>(std::ceil(high.y())));
    for (int y = std::max(0, static_cast<int>(low.y())); y < end_y; ++y) {
        for (int x = std::max(0, static_cast<int>(low.x())); x < end_x; ++x) {
            const Eigen::Vector3d middle(x + 0.5, y + 0.5, 1);
            if ((shares_from_pixel * (middle + kOffEdges_px)).minCoeff() < 0) continue;
            const Eigen::Array3d in_space = (shares_from_pixel * middle).array() * inverse_depths;
            const Eigen::Vector3d shares = in_space / in_space.sum();
            const std::optional<Fragment> drawn = fragment(corners, shares);
            if (!drawn) {
                draw_surroundings(corners, shares, x, y, frame);
                continue;
            }
            const auto over = [&](double front, std::uint8_t back) {
                return nearest_byte(drawn->opacity * front + (1 - drawn->opacity) * back);
            };
            const Rgb8 behind = frame.color(x, y);
            frame.color(x, y) = {over(drawn->color.x(), behind.r), over(drawn->color.y(), behind.g),
                                 over(drawn->color.z(), behind.b)};
            frame.coverage(x, y) =
                over(255 * (is_laid_over ? 1 : drawn->coverage), frame.coverage(x, y));
        }
    }
}

std::optional<TriangleReference::Fragment> TriangleReference::fragment(
    const Corners& corners, const Eigen::Vector3d& shares) const {
    Eigen::Vector3d weights = interpolated(corners, shares, [](const BlendVertex& vertex) {
        return Eigen::Vector3d(vertex.weights[0], vertex.weights[1], vertex.weights[2]);
    });
    Fragment drawn;
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d at = place_of(corners, shares, k);
        const auto view = static_cast<int>(corners[0]->view_layers[k]);
        double& weight = weights[static_cast<Eigen::Index>(k)];
        if (!(at.z() > 0) || !at.allFinite()) {
            weight = 0;
            continue;
        }
        if (places_ == PlaceInterpolation::kLinear)
            weight *= photographs_.opacity(view, at.hnormalized()) / 255;
        drawn.color += weight * photographs_.color(view, at.hnormalized());
    }
    if (places_ == PlaceInterpolation::kLinear) {
        const double sum = weights.sum();
        if (sum < kLeastWeight) return std::nullopt;
        drawn.color /= sum;
        weights /= sum;
    }
    if (debug_picture_ != DebugPicture::kNone)
        drawn.color = debug_color_of(corners, shares, weights);
    const bool is_guess = places_ == PlaceInterpolation::kLinear &&
                          interpolated_number(corners, shares, &BlendVertex::confidence) <
                              static_cast<double>(kLeastConfidence);
    drawn.coverage = is_guess ? 0 : weights.sum();
    drawn.opacity = interpolated_number(corners, shares, &BlendVertex::opacity);
    return drawn;
}

/// Homogeneous. A corner that is not before the view has no place there, and no weight.
Eigen::Vector3d TriangleReference::place_of(const Corners& corners, const Eigen::Vector3d& shares,
                                            std::size_t k) const {
    return interpolated(corners, shares, [&](const BlendVertex& vertex) {
        const Eigen::Vector3d place(vertex.view_pixels[k][0], vertex.view_pixels[k][1], 1);
        if (places_ == PlaceInterpolation::kLinear) return place;
        const auto ratio = static_cast<double>(vertex.depth_ratios[k]);
        if (!(ratio > 0)) return Eigen::Vector3d(0, 0, 0);
        return Eigen::Vector3d(static_cast<double>(vertex.depth) * ratio * place);
    });
}

Eigen::Vector3d TriangleReference::debug_color_of(const Corners& corners,
                                                  const Eigen::Vector3d& shares,
                                                  const Eigen::Vector3d& weights) const {
    ShownRay ray;
    for (std::size_t k = 0; k < 3; ++k) {
        ray.view_indices[k] = static_cast<int>(corners[0]->view_layers[k]);
        ray.weights[k] = weights[static_cast<Eigen::Index>(k)];
    }
    ray.face_index = static_cast<int>(corners[0]->face_index);
    ray.inverse_depth = interpolated_number(corners, shares, &BlendVertex::inverse_depth);
    ray.confidence = interpolated_number(corners, shares, &BlendVertex::confidence);
    ray.occluded = interpolated_number(corners, shares, &BlendVertex::occluded);
    const Eigen::Vector3d color =
        debug_color(debug_picture_, ray, scene_inverse_depths(lumigraph_));
    // The weights of projective textures add up as in the picture, to less than 1 where some are
    // missing.
    return debug_picture_ == DebugPicture::kWeights ? color : weights.sum() * color;
}

Frame draw_reference(const BlendTriangles& triangles, const Lumigraph& lumigraph, const Eye& eye,
                     PlaceInterpolation places, DebugPicture debug_picture) {
    Frame frame = empty_frame(eye.camera);
    TriangleReference(lumigraph, eye, places, debug_picture).draw(triangles, frame);
    return frame;
}

}  // namespace lumi
