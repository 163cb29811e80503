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

    /// A vertex halfway between two nodes, at the depth of the first: there the sample ends.
    std::uint32_t add_end_of(const LatticeNode& node, const LatticeNode& beyond) {
        const Eigen::Vector2f pixel = 0.5F * (lattice_.position_px(node.column, node.row) +
                                              lattice_.position_px(beyond.column, beyond.row));
        vertices_.emplace_back(pixel.x(), pixel.y(), lattice_.inverse_depth(node.column, node.row));
        return static_cast<std::uint32_t>(vertices_.size() - 1);
    }

 private:
    static constexpr std::uint32_t kNone = 0xffffffffU;
    const DepthLattice& lattice_;
    std::vector<Eigen::Vector3f>& vertices_;
    std::vector<std::uint32_t> index_of_node_;
};

using IndicesByKind = std::array<std::vector<std::uint32_t>, kDepthKinds>;

/// The corners of a triangle that tears, each with how it is parted from the two others. Corners
/// go round as in the triangle; the long side runs from the first to the second.
struct TornTriangle {
    std::array<LatticeNode, 3> corners;
    std::array<bool, 3> torn{};  ///< The side from corner i to corner i + 1.
};

TornTriangle torn_triangle(const DepthLattice& lattice, const RightTriangle& triangle) {
    const auto& [a, b, c] = triangle;
    TornTriangle result{{a, b, c},
                        {false, tears_between(lattice, b, c), tears_between(lattice, c, a)}};
    const auto step = [&](const LatticeNode& from, const LatticeNode& to) {
        return std::abs(lattice.inverse_depth(from.column, from.row) -
                        lattice.inverse_depth(to.column, to.row));
    };
    // The ends of the long side are of one surface when both differ from the third corner, but
    // hardly from each other.
    const bool both = result.torn[1] && result.torn[2];
    result.torn[0] = both ? step(a, b) > 0.5F * std::min(step(b, c), step(c, a))
                          : result.torn[1] || result.torn[2];
    return result;
}

/// Each corner's surface up to the middle of the sides on which it tears from the next: an edge
/// lies halfway between the last sample on it and the first beyond.
void append_torn(const DepthLattice& lattice, const RightTriangle& triangle, VertexTable& vertices,
                 IndicesByKind& by_kind) {
    const TornTriangle torn = torn_triangle(lattice, triangle);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        const std::size_t last = (i + 2) % 3;
        const LatticeNode& node = torn.corners[i];
        const bool from_next = torn.torn[i];
        const bool from_last = torn.torn[last];
        if (!from_next || !from_last) continue;
        const auto kind = [&](const LatticeNode& of) -> std::vector<std::uint32_t>& {
            return by_kind[static_cast<std::size_t>(
                lattice.is_seen(of.column, of.row) ? DepthKind::kSeen : DepthKind::kFilled)];
        };
        std::vector<std::uint32_t>& alone = kind(node);
        alone.insert(alone.end(),
                     {vertices.index_of(node), vertices.add_end_of(node, torn.corners[next]),
                      vertices.add_end_of(node, torn.corners[last])});
        if (torn.torn[next]) continue;
        // The two others are of one surface: what is left of the triangle is theirs.
        const LatticeNode& b = torn.corners[next];
        const LatticeNode& c = torn.corners[last];
        std::vector<std::uint32_t>& both = lattice.is_seen(b.column, b.row) ? kind(c) : kind(b);
        const std::uint32_t at_b = vertices.index_of(b);
        const std::uint32_t at_c = vertices.index_of(c);
        const std::uint32_t end_b = vertices.add_end_of(b, node);
        const std::uint32_t end_c = vertices.add_end_of(c, node);
        both.insert(both.end(), {end_b, at_b, at_c, end_b, at_c, end_c});
    }
}

}  // namespace

DepthMesh triangulate(const DepthMap& depth, const Camera& camera, double disparity_px,
                      const DepthMeshOptions& options) {
    DepthMesh mesh;
    if (depth.inverse_depth.empty()) return mesh;
    const DepthLattice lattice(depth, camera, disparity_px);
    const SplitErrors errors(lattice);
    VertexTable vertices(lattice, mesh.vertices);
    IndicesByKind by_kind;
    visit_network(errors, lattice, affordable_error_px(errors, lattice, options),
                  [&](const RightTriangle& triangle) {
                      const DepthKind kind = kind_of(lattice, triangle);
                      if (kind == DepthKind::kStretched)
                          append_torn(lattice, triangle, vertices, by_kind);
                      auto& indices = by_kind[static_cast<std::size_t>(kind)];
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
