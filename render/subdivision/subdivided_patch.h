#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "render/subdivision/blend_triangles.h"
#include "render/subdivision/patch_sampler.h"

namespace lumi {

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
