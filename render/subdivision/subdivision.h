#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "render/depth_search/depth_search.h"
#include "render/faces/face_polygons.h"
#include "render/frame/frame.h"
#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// What is known of the scene at one pixel of a face polygon.
struct PatchSample {
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    bool hits = false;  ///< The ray meets the scene; without, the scene plane stands in for it.
    double inverse_depth = 0.0;

    double confidence = 0.0;              ///< As in the confidence picture.
    double occluded = 0.0;                ///< Share of the ray's weight that is not seen.
    std::array<double, 3> ray_weights{};  ///< Barycentric: from the ray alone.
    std::array<double, 3> weights{};      ///< After occlusion correction; sum 1 or all 0.
    std::array<Eigen::Vector2d, 3> view_pixels{};
    std::array<double, 3> depth_ratios{};  ///< Depth in each view over depth in the eye.
    /// For interpolation in the picture: one over the mean of these ratios.
    double affine_depth = 1.0;
    double depth = 1.0;    ///< One over the inverse depth, not infinite.
    double opacity = 1.0;  ///< What is behind shows through the rest.
};

/// Which depth vertices are drawn with.
enum class VertexDepth {
    kAffine,  ///< Where photographs are looked up is interpolated right, but for how ratios differ.
    kTrue,    ///< Vertices lie at their places in space, for projective textures.
};

/// The sample as a corner of triangles.
[[nodiscard]] BlendVertex blend_vertex(const PatchSample& sample, const FacePolygon& polygon,
                                       VertexDepth depth);

/// Looks at the scene through one face of the camera mesh.
class PatchSampler {
 public:
    struct Options {
        bool correct_occlusion = true;
        /// The paper's rule for points that none of the three sees is weight 0; otherwise such
        /// points keep the weights of their ray.
        bool unseen_is_black = false;
        bool fade_beyond_border = false;
        /// For faces of a shell (CameraMesh::shells), the views that are asked whether something
        /// stands before what the shell's views see.
        std::optional<std::array<int, 3>> before_shell;
    };
    PatchSampler(const FacePolygon& polygon, const DepthSearch& search,
                 const Eigen::Vector3d& scene_plane, const Options& options);

    [[nodiscard]] PatchSample at(const Eigen::Vector2d& pixel) const;
    [[nodiscard]] const FacePolygon& polygon() const { return polygon_; }
    [[nodiscard]] const DepthSearch& search() const { return search_; }

 private:
    [[nodiscard]] std::array<int, 3> by_weight(const std::array<double, 3>& weights) const;
    [[nodiscard]] std::optional<RayHit> first_hit(const PatchSample& sample) const;
    [[nodiscard]] bool is_guess_hidden(const PatchSample& sample, int view) const;
    [[nodiscard]] double opacity_of(const PatchSample& sample,
                                    const std::array<double, 3>& visible) const;

    const FacePolygon& polygon_;
    const DepthSearch& search_;
    Eigen::Vector3d scene_plane_;
    Options options_;
};

/// What a frame asks for, of the camera mesh itself.
[[nodiscard]] PatchSampler::Options sampling_options(const RenderOptions& options);

/// Vertices of a subdivided face polygon; the midpoint of two vertices is made once.
class SubdividedPatch {
 public:
    explicit SubdividedPatch(const PatchSampler& sampler);

    [[nodiscard]] std::uint32_t add(const Eigen::Vector2d& pixel);
    [[nodiscard]] std::uint32_t midpoint(std::uint32_t a, std::uint32_t b);
    [[nodiscard]] std::optional<std::uint32_t> known_midpoint(std::uint32_t a,
                                                              std::uint32_t b) const;
    [[nodiscard]] const PatchSample& operator[](std::uint32_t vertex) const {
        return samples_[vertex];
    }
    [[nodiscard]] double length_px(std::uint32_t a, std::uint32_t b) const {
        return (samples_[a].pixel - samples_[b].pixel).norm();
    }
    /// The corners of the polygon, which are the first vertices.
    [[nodiscard]] std::uint32_t corner_count() const { return corner_count_; }

    /// Appends the triangles with all vertices that they name.
    void append_to(BlendTriangles& drawn,
                   const std::vector<std::array<std::uint32_t, 3>>& triangles,
                   VertexDepth depth) const;

 private:
    [[nodiscard]] static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
        return a < b ? (std::uint64_t{a} << 32) | b : (std::uint64_t{b} << 32) | a;
    }

    const PatchSampler& sampler_;
    std::vector<PatchSample> samples_;
    std::unordered_map<std::uint64_t, std::uint32_t> midpoints_;
    std::uint32_t corner_count_ = 0;
};

}  // namespace lumi
