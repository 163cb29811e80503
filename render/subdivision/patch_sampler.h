#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

#include "render/depth_search/depth_search.h"
#include "render/faces/face_polygons.h"
#include "render/frame/frame.h"
#include "render/subdivision/patch_sample.h"

namespace lumi {

/// Looks at the scene through one face of the camera mesh.
class PatchSampler {
 public:
    struct Options {
        bool correct_occlusion = true;
        /// The paper's rules, where a view sees a point or does not (redistributed_by_the_paper);
        /// otherwise visibility is a ramp, and points that none of the three sees keep the weights
        /// of their ray.
        bool by_the_paper = false;
        bool fade_beyond_border = false;
        /// The views that are asked, for faces of a shell (CameraMesh::shells), whether something
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
    [[nodiscard]] std::size_t first_of_same_view(std::size_t k) const;
    [[nodiscard]] std::optional<RayHit> first_hit(const PatchSample& sample) const;
    void correct_depth(const std::optional<RayHit>& hit, PatchSample& sample) const;
    void look_up(PatchSample& sample) const;
    [[nodiscard]] bool is_guess_hidden(const PatchSample& sample, int view) const;
    [[nodiscard]] std::array<double, 3> visibilities(const std::optional<RayHit>& hit,
                                                     const PatchSample& sample) const;
    void correct_occlusion(const std::array<double, 3>& visible, PatchSample& sample) const;
    [[nodiscard]] double opacity_of(const PatchSample& sample,
                                    const std::array<double, 3>& visible) const;

    const FacePolygon& polygon_;
    const DepthSearch& search_;
    Eigen::Vector3d scene_plane_;
    Options options_;
};

/// What a frame asks for, of the camera mesh itself.
[[nodiscard]] PatchSampler::Options sampling_options(const RenderOptions& options);

}  // namespace lumi
