#include "render/reference/triangle_reference.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "calib/capture/nearest_byte.h"
#include "render/depth_search/occlusion.h"
#include "render/reference/sampling.h"
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

/// What triangles are blended from.
struct Photographs {
    const Lumigraph& lumigraph;
    PlaceInterpolation places;
    std::vector<GrayImage> opacities;
};

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

void draw_pixel(const std::array<const BlendVertex*, 3>& corners, const Eigen::Vector3d& shares,
                const Photographs& photographs, int x, int y, Frame& frame) {
    Eigen::Vector3d weights = interpolated(corners, shares, [](const BlendVertex& vertex) {
        return Eigen::Vector3d(vertex.weights[0], vertex.weights[1], vertex.weights[2]);
    });
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d at = interpolated(corners, shares, [&](const BlendVertex& vertex) {
            const double scale = photographs.places == PlaceInterpolation::kProjective
                                     ? static_cast<double>(vertex.depth) *
                                           static_cast<double>(vertex.depth_ratios[k])
                                     : 1.0;
            return (scale * Eigen::Vector3d(vertex.view_pixels[k][0], vertex.view_pixels[k][1], 1))
                .eval();
        });
        // In a view's focal plane a corner has no place; it has no weight there either.
        if (!(at.z() > 0) || !at.allFinite()) continue;
        const auto view = static_cast<std::size_t>(corners[0]->view_layers[k]);
        double& weight = weights[static_cast<Eigen::Index>(k)];
        if (photographs.places == PlaceInterpolation::kLinear)
            weight *= bilinear_to_zero(photographs.opacities[view], at.hnormalized()) / 255;
        color += weight * bilinear(photographs.lumigraph.views[view].photograph, at.hnormalized());
    }
    if (photographs.places == PlaceInterpolation::kLinear) {
        const double sum = weights.sum();
        if (sum < kLeastWeight) return draw_surroundings(corners, shares, x, y, frame);
        color /= sum;
        weights /= sum;
    }
    const double opacity =
        interpolated(corners, shares, [](const BlendVertex& vertex) {
            return Eigen::Matrix<double, 1, 1>(static_cast<double>(vertex.opacity));
        }).value();
    const auto over = [opacity](double front, std::uint8_t back) {
        return nearest_byte(opacity * front + (1 - opacity) * back);
    };
    const Rgb8 behind = frame.color(x, y);
    frame.color(x, y) = {over(color.x(), behind.r), over(color.y(), behind.g),
                         over(color.z(), behind.b)};
    const double confidence =
        interpolated(corners, shares, [](const BlendVertex& vertex) {
            return Eigen::Matrix<double, 1, 1>(static_cast<double>(vertex.confidence));
        }).value();
    const bool is_guess = photographs.places == PlaceInterpolation::kLinear &&
                          confidence < static_cast<double>(kLeastConfidence);
    frame.coverage(x, y) = over(is_guess ? 0 : 255 * weights.sum(), frame.coverage(x, y));
}

void draw_triangle(const std::array<const BlendVertex*, 3>& corners, const Photographs& photographs,
                   Frame& frame) {
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
            draw_pixel(corners, in_space / in_space.sum(), photographs, x, y, frame);
        }
    }
}

}  // namespace

Frame draw_reference(const BlendTriangles& triangles, const Lumigraph& lumigraph,
                     const Camera& eye_camera, PlaceInterpolation places,
                     const ColorImage& behind) {
    Frame frame{behind.empty() ? ColorImage(eye_camera.width_px, eye_camera.height_px) : behind,
                GrayImage(eye_camera.width_px, eye_camera.height_px),
                {triangles.count()}};
    const Photographs photographs{lumigraph, places, photograph_opacities(lumigraph)};
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        draw_triangle({&triangles.vertices[triangles.indices[i]],
                       &triangles.vertices[triangles.indices[i + 1]],
                       &triangles.vertices[triangles.indices[i + 2]]},
                      photographs, frame);
    }
    return frame;
}

}  // namespace lumi
