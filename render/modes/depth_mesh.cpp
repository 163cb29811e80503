#include "render/modes/depth_mesh.h"

#include <algorithm>
#include <cstdlib>

#include "render/modes/depth_lattice.h"
#include "render/modes/split_errors.h"

namespace lumi {
namespace {

/// A right triangle on the lattice; its long side runs from `a` to `b`.
struct RightTriangle {
    LatticeNode a, b, c;
};

/// Calls `emit` for each triangle of the coarsest network within the error.
template <class Emit>
void visit_triangles(const SplitErrors& errors, const DepthLattice& lattice, float max_error_px,
                     const RightTriangle& triangle, const Emit& emit) {
    const auto& [a, b, c] = triangle;
    if (std::min({a.column, b.column, c.column}) >= lattice.columns() ||
        std::min({a.row, b.row, c.row}) >= lattice.rows())
        return;
    const bool is_smallest = std::abs(a.column - c.column) + std::abs(a.row - c.row) == 1;
    const LatticeNode middle{(a.column + b.column) / 2, (a.row + b.row) / 2};
    if (!is_smallest && errors.at(middle) > max_error_px) {
        visit_triangles(errors, lattice, max_error_px, {c, a, middle}, emit);
        visit_triangles(errors, lattice, max_error_px, {b, c, middle}, emit);
        return;
    }
    for (const LatticeNode& node : {a, b, c})
        if (!lattice.contains(node.column, node.row)) return;
    emit(triangle);
}

template <class Emit>
void visit_network(const SplitErrors& errors, const DepthLattice& lattice, float max_error_px,
                   const Emit& emit) {
    const int side = errors.side();
    visit_triangles(errors, lattice, max_error_px, {{0, 0}, {side, side}, {side, 0}}, emit);
    visit_triangles(errors, lattice, max_error_px, {{side, side}, {0, 0}, {0, side}}, emit);
}

bool tears_between(const DepthLattice& lattice, const LatticeNode& a, const LatticeNode& b) {
    const int column = std::min(a.column, b.column);
    const int row = std::min(a.row, b.row);
    return a.row == b.row ? lattice.tears_right(column, row) : lattice.tears_below(column, row);
}

DepthKind kind_of(const DepthLattice& lattice, const RightTriangle& triangle) {
    const auto& [a, b, c] = triangle;
    const bool is_smallest = std::abs(a.column - c.column) + std::abs(a.row - c.row) == 1;
    // Larger triangles would have been split if there were a tear within.
    if (is_smallest && (tears_between(lattice, a, c) || tears_between(lattice, b, c)))
        return DepthKind::kStretched;
    for (const LatticeNode& node : {a, b, c})
        if (!lattice.is_seen(node.column, node.row)) return DepthKind::kFilled;
    return DepthKind::kSeen;
}

/// The smallest error, doubling from the wanted one, for which there are not too many triangles.
float affordable_error_px(const SplitErrors& errors, const DepthLattice& lattice,
                          const DepthMeshOptions& options) {
    double error_px = options.max_error_px;
    while (true) {
        std::size_t count = 0;
        visit_network(errors, lattice, static_cast<float>(error_px),
                      [&](const RightTriangle&) { ++count; });
        if (count <= options.max_triangles || 2 * error_px > options.max_coarse_error_px)
            return static_cast<float>(error_px);
        error_px *= 2;
    }
}

/// Gathers the vertices that triangles name.
class VertexTable {
 public:
    VertexTable(const DepthLattice& lattice, std::vector<Eigen::Vector3f>& vertices)
        : lattice_(lattice),
          vertices_(vertices),
          index_of_node_(static_cast<std::size_t>(lattice.columns()) *
                             static_cast<std::size_t>(lattice.rows()),
                         kNone) {}

    std::uint32_t index_of(const LatticeNode& node) {
        std::uint32_t& index = index_of_node_[static_cast<std::size_t>(node.row) *
                                                  static_cast<std::size_t>(lattice_.columns()) +
                                              static_cast<std::size_t>(node.column)];
        if (index == kNone) {
            index = static_cast<std::uint32_t>(vertices_.size());
            const Eigen::Vector2f pixel = lattice_.position_px(node.column, node.row);
            vertices_.emplace_back(pixel.x(), pixel.y(),
                                   lattice_.inverse_depth(node.column, node.row));
        }
        return index;
    }

 private:
    static constexpr std::uint32_t kNone = 0xffffffffU;
    const DepthLattice& lattice_;
    std::vector<Eigen::Vector3f>& vertices_;
    std::vector<std::uint32_t> index_of_node_;
};

}  // namespace

DepthMesh triangulate(const DepthMap& depth, const Camera& camera, double disparity_px,
                      const DepthMeshOptions& options) {
    DepthMesh mesh;
    if (depth.inverse_depth.empty()) return mesh;
    const DepthLattice lattice(depth, camera, disparity_px);
    const SplitErrors errors(lattice);
    VertexTable vertices(lattice, mesh.vertices);
    std::array<std::vector<std::uint32_t>, kDepthKinds> by_kind;
    visit_network(errors, lattice, affordable_error_px(errors, lattice, options),
                  [&](const RightTriangle& triangle) {
                      auto& indices = by_kind[static_cast<std::size_t>(kind_of(lattice, triangle))];
                      for (const LatticeNode& node : {triangle.a, triangle.b, triangle.c})
                          indices.push_back(vertices.index_of(node));
                  });
    for (std::size_t kind = 0; kind < by_kind.size(); ++kind) {
        mesh.indices.insert(mesh.indices.end(), by_kind[kind].begin(), by_kind[kind].end());
        mesh.kind_begin[kind + 1] = mesh.indices.size();
    }
    return mesh;
}

}  // namespace lumi
