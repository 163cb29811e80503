#include "render/depth_layers/depth_triangles.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lumi {
namespace {

/// Coordinates of vertices that are drawn in single precision; those of others would be coarse.
constexpr float kFarBeside_px = 1 << 14;
/// Rounding may take a centre out of both triangles at a side: each reaches so far beyond it.
constexpr float kSlack_px = 1e-4F;
/// The same for shares in double precision.
constexpr double kRounding = 1e-12;
/// From this width on rows are cut to where a triangle is.
constexpr int kWide_px = 12;

using Corners = std::array<const WindowVertex*, 3>;

DepthBufferBox box_of(const Corners& corners, const DepthBufferBox& within) {
    const auto [a, b, c] = corners;
    // Texels whose centres can be inside.
    const auto begin = [](float least) { return static_cast<int>(std::ceil(least - 0.5F)); };
    const auto end = [](float most) { return static_cast<int>(std::floor(most + 0.5F)); };
    return {std::max(within.begin_x, begin(std::min({a->x, b->x, c->x}) - kSlack_px)),
            std::max(within.begin_y, begin(std::min({a->y, b->y, c->y}) - kSlack_px)),
            std::min(within.end_x, end(std::max({a->x, b->x, c->x}) + kSlack_px)),
            std::min(within.end_y, end(std::max({a->y, b->y, c->y}) + kSlack_px))};
}

/// What is affine in the window.
struct Affine {
    float at_origin = 0.0F;
    float along_x = 0.0F;
    float along_y = 0.0F;
    float to_zero = 0.0F;  ///< -1 / along_x, where rows are narrowed.

    [[nodiscard]] float in_row(int y) const { return at_origin + along_y * static_cast<float>(y); }
};

/// The side from a to b: not negative to its left, with slack.
Affine side(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
    const Eigen::Vector2f along = b - a;
    const float slack = kSlack_px * (std::abs(along.x()) + std::abs(along.y()));
    return {along.y() * a.x() - along.x() * a.y() + slack, -along.y(), along.x(), 1 / along.y()};
}

/// Narrows a row's texels to those where the side is not negative, give or take one.
void narrow(const Affine& of, float in_row, int& begin, int& end) {
    if (of.along_x == 0.0F) return;
    const float crossing = std::clamp(in_row * of.to_zero, -kFarBeside_px, kFarBeside_px);
    if (of.along_x > 0)
        begin = std::max(begin, static_cast<int>(crossing) - 1);
    else
        end = std::min(end, static_cast<int>(crossing) + 2);
}

struct Range {
    float begin;
    float width;
};

/// What its texels need to know of a triangle; places are from the centre of its box's first texel.
struct OrdinaryTriangle {
    DepthBufferBox box;
    std::array<Affine, 3> sides;
    Affine depth;
    /// Thin triangles are steep: beyond their corners depth would be anything.
    float nearest = 0.0F;
    float farthest = 0.0F;
};

/// Nothing where no texel of the box can be in it, and where it is seen from behind.
std::optional<OrdinaryTriangle> seen_in(const Corners& corners, const Range& range,
                                        const DepthBufferBox& within) {
    const DepthBufferBox box = box_of(corners, within);
    if (box.begin_x >= box.end_x || box.begin_y >= box.end_y) return std::nullopt;
    const Eigen::Vector2f origin(static_cast<float>(box.begin_x) + 0.5F,
                                 static_cast<float>(box.begin_y) + 0.5F);
    const auto place = [&](const WindowVertex* corner) {
        return Eigen::Vector2f(Eigen::Vector2f(corner->x, corner->y) - origin);
    };
    const Eigen::Vector2f a = place(corners[0]);
    const Eigen::Vector2f b = place(corners[1]);
    const Eigen::Vector2f c = place(corners[2]);
    const Eigen::Vector2f ab = b - a;
    const Eigen::Vector2f ac = c - a;
    const float area = ab.x() * ac.y() - ab.y() * ac.x();
    if (!(area > 0.0F)) return std::nullopt;
    const auto in_range = [&](const WindowVertex* corner) {
        return range.begin + range.width * corner->depth;
    };
    const Eigen::Vector3f depths(in_range(corners[0]), in_range(corners[1]), in_range(corners[2]));
    const float to_b = (depths[1] - depths[0]) / area;
    const float to_c = (depths[2] - depths[0]) / area;
    const float along_x = to_b * ac.y() - to_c * ab.y();
    const float along_y = to_c * ab.x() - to_b * ac.x();
    return OrdinaryTriangle{box,
                            {side(a, b), side(b, c), side(c, a)},
                            {depths[0] - along_x * a.x() - along_y * a.y(), along_x, along_y, 0.0F},
                            depths.minCoeff(),
                            depths.maxCoeff()};
}

void draw_row(const OrdinaryTriangle& triangle, int row, float* texels) {
    const auto& [side0, side1, side2] = triangle.sides;
    const float in_row0 = side0.in_row(row);
    const float in_row1 = side1.in_row(row);
    const float in_row2 = side2.in_row(row);
    const float depth_in_row = triangle.depth.in_row(row);
    int begin = 0;
    int end = triangle.box.end_x - triangle.box.begin_x;
    if (end >= kWide_px) {
        narrow(side0, in_row0, begin, end);
        narrow(side1, in_row1, begin, end);
        narrow(side2, in_row2, begin, end);
    }
    // Without branches, so that it is done for several texels at once.
    for (int i = begin; i < end; ++i) {
        const auto x = static_cast<float>(i);
        const float inside =
            std::min(std::min(in_row0 + side0.along_x * x, in_row1 + side1.along_x * x),
                     in_row2 + side2.along_x * x);
        const float depth =
            std::min(std::max(depth_in_row + triangle.depth.along_x * x, triangle.nearest),
                     triangle.farthest);
        texels[i] = std::min(texels[i], inside >= 0.0F ? depth : 1.0F);
    }
}

void draw_ordinary(const OrdinaryTriangle& triangle, const DepthBuffer& buffer) {
    const DepthBufferBox& box = triangle.box;
    for (int row = 0; row < box.end_y - box.begin_y; ++row)
        draw_row(triangle, row,
                 buffer.texels.data() +
                     static_cast<std::ptrdiff_t>(box.begin_y + row) * buffer.width + box.begin_x);
}

/// Corners (X, Y, W) as columns, and depth * W.
struct HomogeneousTriangle {
    Eigen::Matrix3d corners;
    Eigen::Vector3d depths;

    /// Whether all of it lies beyond one side of the box, behind the eye, or too near.
    [[nodiscard]] bool is_beside(const DepthBufferBox& box) const {
        const auto x = corners.row(0).array();
        const auto y = corners.row(1).array();
        const auto w = corners.row(2).array();
        return (w <= 0).all() || (depths.array() < 0).all() || (x < box.begin_x * w).all() ||
               (x > box.end_x * w).all() || (y < box.begin_y * w).all() ||
               (y > box.end_y * w).all();
    }
};

/// Homogeneous rasterisation (Olano, Greer 1997), in double precision: a centre is inside, and
/// before the eye, where no corner has a negative share.
void draw_any(const HomogeneousTriangle& triangle, const Range& range, const DepthBufferBox& box,
              const DepthBuffer& buffer) {
    if (triangle.is_beside(box) || !(triangle.corners.determinant() > 0)) return;
    const Eigen::Matrix3d shares_from_pixel = triangle.corners.inverse();
    for (int y = box.begin_y; y < box.end_y; ++y) {
        const Eigen::Vector3d in_row = shares_from_pixel * Eigen::Vector3d(0.5, y + 0.5, 1);
        double begin = box.begin_x;
        double end = box.end_x;
        for (Eigen::Index i = 0; i < 3; ++i) {
            const double along_x = shares_from_pixel(i, 0);
            const double crossing = -in_row[i] / along_x;
            if (along_x > 0) begin = std::max(begin, crossing);
            if (along_x < 0) end = std::min(end, crossing + 1);
            if (along_x == 0 && in_row[i] < 0) end = begin;
        }
        if (!(begin < end)) continue;
        float* texels = buffer.texels.data() + static_cast<std::ptrdiff_t>(y) * buffer.width;
        for (int x = static_cast<int>(begin); x < static_cast<int>(std::ceil(end)); ++x) {
            const Eigen::Vector3d shares = in_row + x * shares_from_pixel.col(0);
            const double depth = shares.dot(triangle.depths);
            // Nearer than 0 is nearer than can be drawn.
            if (shares.minCoeff() < -kRounding * shares.cwiseAbs().maxCoeff() || depth < 0)
                continue;
            texels[x] = std::min(texels[x], range.begin + range.width * static_cast<float>(depth));
        }
    }
}

}  // namespace

WindowVertex window_vertex(const Eigen::Matrix4f& window_from_view, const Eigen::Vector3f& vertex) {
    const Eigen::Vector4f at =
        window_from_view * Eigen::Vector4f(vertex.x(), vertex.y(), 1.0F, vertex.z());
    if (!(at.z() > 0.0F)) return {};
    const float inverse = 1.0F / at.z();
    WindowVertex result{at.x() * inverse, at.y() * inverse, at.w() * inverse, false};
    result.is_ordinary = std::abs(result.x) < kFarBeside_px && std::abs(result.y) < kFarBeside_px &&
                         result.depth >= 0.0F;
    return result;
}

void draw_depth_triangles(const WindowMesh& mesh, std::size_t first_index, std::size_t index_count,
                          float range_begin, float range_width, const DepthBufferBox& box,
                          const DepthBuffer& buffer) {
    const Range range{range_begin, range_width};
    for (std::size_t i = first_index; i < first_index + index_count; i += 3) {
        const Corners corners{&mesh.in_window[mesh.indices[i]],
                              &mesh.in_window[mesh.indices[i + 1]],
                              &mesh.in_window[mesh.indices[i + 2]]};
        if (corners[0]->is_ordinary && corners[1]->is_ordinary && corners[2]->is_ordinary) {
            if (const auto triangle = seen_in(corners, range, box))
                draw_ordinary(*triangle, buffer);
            continue;
        }
        HomogeneousTriangle triangle;
        for (Eigen::Index corner = 0; corner < 3; ++corner) {
            const Eigen::Vector3f& vertex =
                mesh.vertices[mesh.indices[i + static_cast<std::size_t>(corner)]];
            const Eigen::Vector4d at =
                (mesh.window_from_view * Eigen::Vector4f(vertex.x(), vertex.y(), 1.0F, vertex.z()))
                    .cast<double>();
            triangle.corners.col(corner) = at.head<3>();
            triangle.depths[corner] = at.w();
        }
        draw_any(triangle, range, box, buffer);
    }
}

}  // namespace lumi
