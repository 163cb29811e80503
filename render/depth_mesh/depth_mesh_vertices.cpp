#include "render/depth_mesh/depth_mesh_vertices.h"

#include <cstddef>

#include "render/depth_mesh/surface_end.h"

namespace lumi {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

}  // namespace

DepthMeshVertices::DepthMeshVertices(const DepthLattice& lattice,
                                     std::vector<Eigen::Vector3f>& vertices)
    : lattice_(lattice),
      vertices_(vertices),
      index_of_node_(
          static_cast<std::size_t>(lattice.columns()) * static_cast<std::size_t>(lattice.rows()),
          kNone) {}

std::uint32_t DepthMeshVertices::index_of(const LatticeNode& node) {
    std::uint32_t& index = index_of_node_[static_cast<std::size_t>(node.row) *
                                              static_cast<std::size_t>(lattice_.columns()) +
                                          static_cast<std::size_t>(node.column)];
    if (index == kNone) {
        index = static_cast<std::uint32_t>(vertices_.size());
        const Eigen::Vector2f pixel = lattice_.position_px(node.column, node.row);
        vertices_.emplace_back(pixel.x(), pixel.y(), lattice_.inverse_depth(node.column, node.row));
    }
    return index;
}

std::uint32_t DepthMeshVertices::add_end_of(const LatticeNode& node, const LatticeNode& beyond) {
    const Eigen::Vector2f pixel = 0.5F * (lattice_.position_px(node.column, node.row) +
                                          lattice_.position_px(beyond.column, beyond.row));
    vertices_.emplace_back(pixel.x(), pixel.y(),
                           inverse_depth_at_end(last_samples(node, beyond),
                                                lattice_.inverse_depth(beyond.column, beyond.row)));
    return static_cast<std::uint32_t>(vertices_.size() - 1);
}

/// Of the node's surface on the way to the node beyond, from the last back. Along rows and columns
/// alone is it known whether there are more than one.
std::vector<float> DepthMeshVertices::last_samples(const LatticeNode& node,
                                                   const LatticeNode& beyond) const {
    std::vector<float> samples{lattice_.inverse_depth(node.column, node.row)};
    const LatticeNode step{node.column - beyond.column, node.row - beyond.row};
    if (step.column != 0 && step.row != 0) return samples;
    LatticeNode from = node;
    while (samples.size() < kEndSamples) {
        const LatticeNode next{from.column + step.column, from.row + step.row};
        if (!lattice_.contains(next.column, next.row) || lattice_.tears_between(from, next) ||
            lattice_.is_seen(next.column, next.row) != lattice_.is_seen(node.column, node.row))
            break;
        samples.push_back(lattice_.inverse_depth(next.column, next.row));
        from = next;
    }
    return samples;
}

}  // namespace lumi
