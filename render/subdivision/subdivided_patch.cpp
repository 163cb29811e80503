#include "render/subdivision/subdivided_patch.h"

namespace lumi {

SubdividedPatch::SubdividedPatch(const PatchSampler& sampler) : sampler_(sampler) {
    for (const Eigen::Vector2d& corner : sampler.polygon().corners_px)
        static_cast<void>(add(corner));
    corner_count_ = static_cast<std::uint32_t>(samples_.size());
}

std::uint32_t SubdividedPatch::add(const Eigen::Vector2d& pixel) {
    samples_.push_back(sampler_.at(pixel));
    return static_cast<std::uint32_t>(samples_.size() - 1);
}

std::uint32_t SubdividedPatch::midpoint(std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] = midpoints_.try_emplace(key(a, b), 0U);
    if (is_new) found->second = add(0.5 * (samples_[a].pixel + samples_[b].pixel));
    return found->second;
}

std::optional<std::uint32_t> SubdividedPatch::known_midpoint(std::uint32_t a,
                                                             std::uint32_t b) const {
    const auto found = midpoints_.find(key(a, b));
    if (found == midpoints_.end()) return std::nullopt;
    return found->second;
}

void SubdividedPatch::append_to(BlendTriangles& drawn,
                                const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                VertexDepth depth) const {
    constexpr std::uint32_t kNone = 0xffffffffU;
    std::vector<std::uint32_t> index_of(samples_.size(), kNone);
    const FacePolygon& polygon = sampler_.polygon();
    for (const auto& triangle : triangles) {
        for (const std::uint32_t vertex : triangle) {
            if (index_of[vertex] == kNone) {
                index_of[vertex] = static_cast<std::uint32_t>(drawn.vertices.size());
                drawn.vertices.push_back(blend_vertex(samples_[vertex], polygon, depth));
            }
            drawn.indices.push_back(index_of[vertex]);
        }
    }
}

}  // namespace lumi
