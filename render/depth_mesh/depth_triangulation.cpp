#include "render/depth_mesh/depth_triangulation.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "render/depth_mesh/depth_lattice.h"
#include "render/depth_mesh/depth_mesh_vertices.h"
#include "render/depth_mesh/halved_depth.h"
#include "render/depth_mesh/mesh_decimation.h"
#include "render/depth_mesh/split_errors.h"
#include "render/depth_mesh/surface_tears.h"

namespace lumi {
namespace {

/// A right triangle on the lattice; its long side runs from `a` to `b`.
struct RightTriangle {
    LatticeNode a, b, c;
};

/// Calls `emit` for each triangle of the coarsest network within the error; some reach beyond the
/// lattice, those that lie beyond it do not count.
template <class Emit>
void visit_triangles(const SplitErrors& errors, const DepthLattice& lattice, float max_error_px,
                     const RightTriangle& triangle, const Emit& emit) {
    const auto& [a, b, c] = triangle;
    if (std::min({a.column, b.column, c.column}) >= lattice.columns() - 1 ||
        std::min({a.row, b.row, c.row}) >= lattice.rows() - 1)
        return;
    const bool is_smallest = std::abs(a.column - c.column) + std::abs(a.row - c.row) == 1;
    const LatticeNode middle{(a.column + b.column) / 2, (a.row + b.row) / 2};
    if (!is_smallest && errors.at(middle) > max_error_px) {
        visit_triangles(errors, lattice, max_error_px, {c, a, middle}, emit);
        visit_triangles(errors, lattice, max_error_px, {b, c, middle}, emit);
        return;
    }
    emit(triangle);
}

template <class Emit>
void visit_network(const SplitErrors& errors, const DepthLattice& lattice, float max_error_px,
                   const Emit& emit) {
    const auto visit = [&](const RightTriangle& triangle) {
        visit_triangles(errors, lattice, max_error_px, triangle, emit);
    };
    for (int y = 0; y < errors.squares_in_column(); ++y) {
        for (int x = 0; x < errors.squares_in_row(); ++x) {
            const int left = x * errors.side();
            const int top = y * errors.side();
            const int right = left + errors.side();
            const int bottom = top + errors.side();
            // The diagonal falls, in every other square it rises.
            if ((x + y) % 2 == 0) {
                visit({{left, top}, {right, bottom}, {right, top}});
                visit({{right, bottom}, {left, top}, {left, bottom}});
            } else {
                visit({{left, bottom}, {right, top}, {left, top}});
                visit({{right, top}, {left, bottom}, {right, bottom}});
            }
        }
    }
}

DepthKind kind_of(const DepthLattice& lattice, const RightTriangle& triangle) {
    const auto& [a, b, c] = triangle;
    const bool is_smallest = std::abs(a.column - c.column) + std::abs(a.row - c.row) == 1;
    // Larger triangles would have been split if there were a tear within.
    if (is_smallest && (lattice.tears_between(a, c) || lattice.tears_between(b, c)))
        return DepthKind::kStretched;
    for (const LatticeNode& node : {a, b, c})
        if (lattice.contains(node.column, node.row) && !lattice.is_seen(node.column, node.row))
            return DepthKind::kFilled;
    return DepthKind::kSeen;
}

struct Network {
    float error_px = 0.0F;
    std::size_t triangles = 0;
};

/// The smallest error, doubling from the wanted one, for which there are not too many triangles.
Network affordable_network(const SplitErrors& errors, const DepthLattice& lattice,
                           const DepthMeshOptions& options) {
    double error_px = options.max_error_px;
    while (true) {
        Network network{static_cast<float>(error_px)};
        visit_network(errors, lattice, network.error_px,
                      [&](const RightTriangle&) { ++network.triangles; });
        if (network.triangles <= options.max_triangles ||
            2 * error_px > options.max_coarse_error_px)
            return network;
        error_px *= 2;
    }
}

/// What a right triangle that reaches beyond the photograph has within it, as a fan. Neighbours cut
/// the side that they share at the same point.
class BorderCut {
 public:
    BorderCut(const DepthLattice& lattice, std::vector<Eigen::Vector3f>& vertices)
        : lattice_(lattice),
          vertices_(vertices),
          border_px_(lattice.position_px(lattice.columns() - 1, lattice.rows() - 1)) {}

    void append(const RightTriangle& triangle, std::vector<std::uint32_t>& indices) {
        std::vector<Eigen::Vector3f> corners;
        for (const LatticeNode& node : {triangle.a, triangle.b, triangle.c}) {
            const Eigen::Vector2f pixel = lattice_.position_px(node.column, node.row);
            corners.emplace_back(pixel.x(), pixel.y(),
                                 lattice_.continued_inverse_depth(node.column, node.row));
        }
        corners = cut(cut(corners, 0), 1);
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        vertices_.insert(vertices_.end(), corners.begin(), corners.end());
        for (std::uint32_t i = 2; i < corners.size(); ++i)
            indices.insert(indices.end(), {first, first + i - 1, first + i});
    }

 private:
    /// The part of a convex polygon up to the border in x (0) or y (1); nothing without area.
    [[nodiscard]] std::vector<Eigen::Vector3f> cut(const std::vector<Eigen::Vector3f>& corners,
                                                   Eigen::Index axis) const {
        std::vector<Eigen::Vector3f> kept;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Eigen::Vector3f& from = corners[i];
            const Eigen::Vector3f& to = corners[(i + 1) % corners.size()];
            if (from[axis] <= border_px_[axis]) kept.push_back(from);
            const bool goes_out = from[axis] < border_px_[axis] && to[axis] > border_px_[axis];
            const bool comes_in = from[axis] > border_px_[axis] && to[axis] < border_px_[axis];
            if (goes_out) kept.push_back(at_border(from, to, axis));
            if (comes_in) kept.push_back(at_border(to, from, axis));
        }
        return kept;
    }

    [[nodiscard]] Eigen::Vector3f at_border(const Eigen::Vector3f& inside,
                                            const Eigen::Vector3f& outside,
                                            Eigen::Index axis) const {
        const float share = (border_px_[axis] - inside[axis]) / (outside[axis] - inside[axis]);
        Eigen::Vector3f cut = inside + share * (outside - inside);
        cut[axis] = border_px_[axis];
        return cut;
    }

    const DepthLattice& lattice_;
    std::vector<Eigen::Vector3f>& vertices_;
    Eigen::Vector2f border_px_;
};

/// By how much of the pitch the ends of surfaces, and borders between seen and filled, may move
/// when vertices are left out; ends of guesses more (DepthMeshOptions::guess_error_ratio).
constexpr double kMaxMovedTear = 0.5;
constexpr double kMaxMovedKindBorder = 1.0;

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
                        {false, lattice.tears_between(b, c), lattice.tears_between(c, a)}};
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
void append_torn(const DepthLattice& lattice, const RightTriangle& triangle,
                 DepthMeshVertices& vertices, IndicesByKind& by_kind) {
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

bool is_within(const DepthLattice& lattice, const RightTriangle& triangle) {
    return lattice.contains(std::max({triangle.a.column, triangle.b.column, triangle.c.column}),
                            std::max({triangle.a.row, triangle.b.row, triangle.c.row}));
}

bool reaches_infinity(const DepthLattice& lattice, const RightTriangle& triangle) {
    const std::array<LatticeNode, 3> nodes{triangle.a, triangle.b, triangle.c};
    return std::any_of(nodes.begin(), nodes.end(), [&](const LatticeNode& node) {
        return lattice.inverse_depth(node.column, node.row) <= 0.0F;
    });
}

DepthMesh mesh_of(const SplitErrors& errors, const DepthLattice& lattice, float error_px) {
    DepthMesh mesh;
    DepthMeshVertices vertices(lattice, mesh.vertices);
    BorderCut border(lattice, mesh.vertices);
    IndicesByKind by_kind;
    visit_network(errors, lattice, error_px, [&](const RightTriangle& triangle) {
        const DepthKind kind = kind_of(lattice, triangle);
        std::vector<std::uint32_t>& indices = by_kind[static_cast<std::size_t>(kind)];
        if (!is_within(lattice, triangle)) return border.append(triangle, indices);
        if (kind == DepthKind::kStretched) {
            append_torn(lattice, triangle, vertices, by_kind);
            if (reaches_infinity(lattice, triangle)) return;
        }
        for (const LatticeNode& node : {triangle.a, triangle.b, triangle.c})
            indices.push_back(vertices.index_of(node));
    });
    for (std::size_t kind = 0; kind < by_kind.size(); ++kind) {
        mesh.indices.insert(mesh.indices.end(), by_kind[kind].begin(), by_kind[kind].end());
        mesh.kind_begin[kind + 1] = mesh.indices.size();
    }
    return mesh;
}

}  // namespace

bool is_of_noise(const DepthMesh& mesh, const DepthMap& depth) {
    return mesh.columns < depth.inverse_depth.width();
}

double most_error_px(const DepthMeshOptions& options, bool is_of_noise) {
    const double decimated_share = is_of_noise && options.decimated_share > 0
                                       ? options.noisy_decimated_share
                                       : options.decimated_share;
    const double coarsest_px =
        is_of_noise ? options.max_noisy_error_px : options.max_coarse_error_px;
    return (1 + decimated_share) * std::max(options.max_error_px, coarsest_px);
}

DepthMesh triangulate(const DepthMap& depth, const Camera& camera, double disparity_px,
                      const DepthMeshOptions& options) {
    if (depth.inverse_depth.empty()) return {};
    const DepthLattice lattice(depth, camera, disparity_px);
    const SplitErrors errors(lattice, options.guess_error_ratio);
    const Network network = affordable_network(errors, lattice, options);
    const auto samples = static_cast<double>(depth.inverse_depth.pixels().size());
    if (network.triangles > options.max_triangles &&
        static_cast<double>(network.triangles) > options.max_triangles_per_sample * samples) {
        const double gap = gentle_step(disparity_per_pitch(depth, camera, disparity_px).along_row);
        const DepthMap half = halved(depth, gap);
        DepthMeshOptions as_it_is = options;
        as_it_is.max_coarse_error_px = options.max_noisy_error_px;
        as_it_is.max_triangles_per_sample = std::numeric_limits<double>::infinity();
        if (options.decimated_share > 0) as_it_is.decimated_share = options.noisy_decimated_share;
        return triangulate(half, camera, disparity_px, as_it_is);
    }
    DepthMesh mesh = mesh_of(errors, lattice, network.error_px);
    const auto network_error_px = static_cast<double>(network.error_px);
    if (options.decimated_share > 0) {
        const double pitch_px = static_cast<double>(camera.width_px) / depth.inverse_depth.width();
        mesh = decimated(mesh, disparity_px,
                         {.max_error_px = options.decimated_share * network_error_px,
                          .guess_error_ratio = options.guess_error_ratio,
                          .max_tear_px = kMaxMovedTear * pitch_px,
                          .max_kind_border_px = kMaxMovedKindBorder * pitch_px});
    }
    mesh.columns = depth.inverse_depth.width();
    mesh.rows = depth.inverse_depth.height();
    mesh.wanted_error_px = options.max_error_px;
    mesh.error_px = (1 + options.decimated_share) * network_error_px;
    mesh.disparity_px = disparity_px;
    return mesh;
}

}  // namespace lumi
