#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/reference/photograph_samples.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// How places in photographs vary on a triangle.
enum class PlaceInterpolation {
    kLinear,      ///< Linearly in space: shaders/blend.glsl.
    kProjective,  ///< As a projective texture: shaders/projective_pass.glsl.
};

/// Triangles blended from three photographs each, in plain code: what the modes that subdivide are
/// tested against. Photographs are looked up as the eye's frame does (PhotographSamples).
///
/// Pixels whose centre no triangle covers, or where no photograph shows anything, stay as they are,
/// or get the surroundings that the vertices know; where several triangles cover one, the last is
/// seen, or as much of it as its opacity says.
class TriangleReference {
 public:
    /// The Lumigraph must outlive it.
    TriangleReference(const Lumigraph& lumigraph, const Eye& eye, PlaceInterpolation places,
                      DebugPicture debug_picture = DebugPicture::kNone);

    /// Draws into a frame of the eye's size. Coverage is the sum of the weights, times the opacity;
    /// guesses are not covered (kLeastConfidence), but for projective textures.
    void draw(const BlendTriangles& triangles, Frame& frame) const;
    /// Draws over a frame: what triangles hide counts as covered, guess or not.
    void lay_over(const BlendTriangles& triangles, Frame& frame) const;

 private:
    using Corners = std::array<const BlendVertex*, 3>;
    /// What is drawn on a pixel.
    struct Fragment {
        Eigen::Vector3d color = Eigen::Vector3d::Zero();
        double coverage = 0.0;  ///< But for the opacity.
        double opacity = 1.0;
    };

    void draw(const BlendTriangles& triangles, bool is_laid_over, Frame& frame) const;
    void draw_triangle(const Corners& corners, bool is_laid_over, Frame& frame) const;
    /// `shares` are those of the corners. None where no photograph shows anything.
    [[nodiscard]] std::optional<Fragment> fragment(const Corners& corners,
                                                   const Eigen::Vector3d& shares) const;
    /// Where photograph k is looked up.
    [[nodiscard]] Eigen::Vector3d place_of(const Corners& corners, const Eigen::Vector3d& shares,
                                           std::size_t k) const;
    [[nodiscard]] Eigen::Vector3d debug_color_of(const Corners& corners,
                                                 const Eigen::Vector3d& shares,
                                                 const Eigen::Vector3d& weights) const;

    const Lumigraph& lumigraph_;
    PhotographSamples photographs_;
    PlaceInterpolation places_;
    DebugPicture debug_picture_;
};

/// The triangles alone, in a frame that was black.
[[nodiscard]] Frame draw_reference(const BlendTriangles& triangles, const Lumigraph& lumigraph,
                                   const Eye& eye, PlaceInterpolation places,
                                   DebugPicture debug_picture = DebugPicture::kNone);

}  // namespace lumi
