#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/depth_mesh/depth_lattice.h"

namespace lumi {

/// Gathers the vertices that the triangles of a depth mesh name: nodes of its lattice, and the ends
/// of surfaces between them.
class DepthMeshVertices {
 public:
    /// Adds to `vertices`: pixels of the photograph, and inverse depth. Both must outlive it.
    DepthMeshVertices(const DepthLattice& lattice, std::vector<Eigen::Vector3f>& vertices);

    [[nodiscard]] std::uint32_t index_of(const LatticeNode& node);

    /// A vertex halfway between two neighbours that tear from each other: there the surface of the
    /// first ends (surface_end.h).
    [[nodiscard]] std::uint32_t add_end_of(const LatticeNode& node, const LatticeNode& beyond);

 private:
    [[nodiscard]] std::vector<float> last_samples(const LatticeNode& node,
                                                  const LatticeNode& beyond) const;

    const DepthLattice& lattice_;
    std::vector<Eigen::Vector3f>& vertices_;
    std::vector<std::uint32_t> index_of_node_;
};

}  // namespace lumi
