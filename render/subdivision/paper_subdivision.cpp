#include "render/subdivision/paper_subdivision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <unordered_set>

#include "render/subdivision/subdivided_patch.h"
#include "render/transfer/polygon_extent.h"
#include "render/transfer/scene_plane.h"

namespace lumi {
namespace {

using CornerIndices = std::array<std::uint32_t, 3>;

/// Vertices that lie on the borders of patches, from both sides: a patch's polygon reaches a
/// hundredth of a pixel into its neighbour, so places that near are the same.
class BorderVertices {
 public:
    void add(const Eigen::Vector2d& pixel) { cells_.insert(cell(pixel, 0, 0)); }
    [[nodiscard]] bool contains(const Eigen::Vector2d& pixel) const {
        for (int step_y = -1; step_y <= 1; ++step_y)
            for (int step_x = -1; step_x <= 1; ++step_x)
                if (cells_.contains(cell(pixel, step_x, step_y))) return true;
        return false;
    }

 private:
    static std::uint64_t cell(const Eigen::Vector2d& pixel, int step_x, int step_y) {
        constexpr double kCellsPerPixel = 16.0;
        const auto place = [](double value, int step) {
            return static_cast<std::uint64_t>(static_cast<std::uint32_t>(
                static_cast<int>(std::floor(value * kCellsPerPixel)) + step));
        };
        return (place(pixel.x(), step_x) << 32) | place(pixel.y(), step_y);
    }
    std::unordered_set<std::uint64_t> cells_;
};

/// A side product vanishes on the border that the patch shares with its neighbour.
bool is_on_border(const PatchSample& a, const PatchSample& b) {
    for (std::size_t k = 0; k < 3; ++k)
        if (a.ray_weights[k] < 1e-9 && b.ray_weights[k] < 1e-9) return true;
    return false;
}

class PaperPatch {
 public:
    PaperPatch(const FacePolygon& polygon, const DepthSearch& search,
               const Eigen::Vector3d& scene_plane, double depth_threshold, bool correct_occlusion,
               const PaperSubdivisionOptions& options)
        : options_(options),
          depth_threshold_(depth_threshold),
          sampler_(
              polygon, search, scene_plane,
              {.correct_occlusion = correct_occlusion, .by_the_paper = true, .before_shell = {}}),
          vertices_(sampler_) {}

    void subdivide(BorderVertices& border) {
        for (std::uint32_t i = 1; i + 1 < vertices_.corner_count(); ++i)
            subdivide({0, i, i + 1}, border);
    }

    void remove_t_vertices(const BorderVertices& border, BlendTriangles& drawn) {
        std::vector<CornerIndices> whole;
        for (const CornerIndices& leaf : leaves_) split_where_neighbours_did(leaf, border, whole);
        vertices_.append_to(drawn, whole, VertexDepth::kTrue);
    }

 private:
    void subdivide(const CornerIndices& triangle, BorderVertices& border) {
        const auto [a, b, c] = triangle;
        const double size = std::max(
            {vertices_.length_px(a, b), vertices_.length_px(b, c), vertices_.length_px(c, a)});
        if (size <= options_.max_size_px) {
            const PatchSample centre =
                sampler_.at((vertices_[a].pixel + vertices_[b].pixel + vertices_[c].pixel) / 3);
            const int hits = count_hits(triangle) + (centre.hits ? 1 : 0);
            if (hits == 0) return;
            const bool is_smallest = size < options_.min_size_px;
            if ((hits == 4 && is_flat(triangle, centre)) || (is_smallest && centre.hits))
                leaves_.push_back(triangle);
            if ((hits == 4 && is_flat(triangle, centre)) || is_smallest) return;
        }
        const std::uint32_t bc = split(b, c, border);
        const std::uint32_t ca = split(c, a, border);
        const std::uint32_t ab = split(a, b, border);
        subdivide({a, ab, ca}, border);
        subdivide({ab, b, bc}, border);
        subdivide({ca, bc, c}, border);
        subdivide({ab, bc, ca}, border);
    }

    [[nodiscard]] int count_hits(const CornerIndices& triangle) const {
        return static_cast<int>(std::count_if(triangle.begin(), triangle.end(),
                                              [&](std::uint32_t i) { return vertices_[i].hits; }));
    }

    [[nodiscard]] bool is_flat(const CornerIndices& triangle, const PatchSample& centre) const {
        double nearest = centre.inverse_depth;
        double farthest = centre.inverse_depth;
        for (const std::uint32_t i : triangle) {
            nearest = std::max(nearest, vertices_[i].inverse_depth);
            farthest = std::min(farthest, vertices_[i].inverse_depth);
        }
        // In depths, 1 / farthest - 1 / nearest <= threshold, without dividing by zero.
        return nearest - farthest <= depth_threshold_ * nearest * farthest;
    }

    std::uint32_t split(std::uint32_t a, std::uint32_t b, BorderVertices& border) {
        const std::uint32_t middle = vertices_.midpoint(a, b);
        if (is_on_border(vertices_[a], vertices_[b])) border.add(vertices_[middle].pixel);
        return middle;
    }

    [[nodiscard]] bool is_split(std::uint32_t a, std::uint32_t b,
                                const BorderVertices& border) const {
        if (vertices_.known_midpoint(a, b)) return true;
        return is_on_border(vertices_[a], vertices_[b]) &&
               border.contains(0.5 * (vertices_[a].pixel + vertices_[b].pixel));
    }

    /// Thinner than polygons overlap, so that nothing is seen of it. Halves of such a triangle need
    /// not be smaller: without this end they could return to where they began.
    [[nodiscard]] bool is_sliver(const CornerIndices& triangle) const {
        const auto [a, b, c] = triangle;
        const Eigen::Vector2d ab = vertices_[b].pixel - vertices_[a].pixel;
        const Eigen::Vector2d ac = vertices_[c].pixel - vertices_[a].pixel;
        const double doubled_area = doubled_area_px2(ab, ac);
        const double longest = std::max({ab.norm(), ac.norm(), vertices_.length_px(b, c)});
        return !(doubled_area > kOverlap_px * longest);
    }

    /// Each step halves the area, and edges never grow: slivers are reached, and end it.
    void split_where_neighbours_did(const CornerIndices& triangle, const BorderVertices& border,
                                    std::vector<CornerIndices>& whole) {
        for (std::size_t i = 0; i < 3 && !is_sliver(triangle); ++i) {
            const std::uint32_t a = triangle[i];
            const std::uint32_t b = triangle[(i + 1) % 3];
            const std::uint32_t c = triangle[(i + 2) % 3];
            if (vertices_.length_px(a, b) < 0.5 || !is_split(a, b, border)) continue;
            const std::uint32_t middle = vertices_.midpoint(a, b);
            split_where_neighbours_did({a, middle, c}, border, whole);
            split_where_neighbours_did({middle, b, c}, border, whole);
            return;
        }
        whole.push_back(triangle);
    }

    const PaperSubdivisionOptions& options_;
    double depth_threshold_;
    PatchSampler sampler_;
    SubdividedPatch vertices_;
    std::vector<CornerIndices> leaves_;
};

}  // namespace

BlendTriangles paper_subdivision(const std::vector<FacePolygon>& polygons,
                                 const DepthSearch& search, const Eigen::Vector3d& scene_plane,
                                 const InverseDepthRange& scene, bool correct_occlusion,
                                 const PaperSubdivisionOptions& options) {
    const double near_depth = 1 / scene.near;
    const double far_depth = scene.far > 0 ? 1 / scene.far : 2 * near_depth;
    const double threshold = options.depth_threshold_share * (far_depth - near_depth);
    BorderVertices border;
    std::vector<std::unique_ptr<PaperPatch>> patches;
    for (const FacePolygon& polygon : polygons) {
        patches.push_back(std::make_unique<PaperPatch>(polygon, search, scene_plane, threshold,
                                                       correct_occlusion, options));
        patches.back()->subdivide(border);
    }
    BlendTriangles drawn;
    for (const auto& patch : patches) patch->remove_t_vertices(border, drawn);
    return drawn;
}

BlendTriangles paper_triangles(const std::vector<FacePolygon>& polygons, const Lumigraph& lumigraph,
                               const SearchedViews& searched_views, const Eye& eye,
                               const RenderOptions& options) {
    const double samples = samples_along_pixel(options);
    return paper_subdivision(polygons, DepthSearch(lumigraph, searched_views, eye),
                             scene_plane_inverse_depth(lumigraph, eye),
                             scene_inverse_depths(lumigraph), options.correct_occlusion,
                             {.depth_threshold_share = options.depth_threshold_share,
                              .min_size_px = samples * options.min_triangle_px,
                              .max_size_px = samples * options.max_triangle_px});
}

}  // namespace lumi
