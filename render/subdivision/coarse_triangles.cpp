#include "render/subdivision/coarse_triangles.h"

#include <algorithm>
#include <utility>

#include "render/subdivision/edge_table.h"

namespace lumi {
namespace {

/// Splits the triangles of one picture.
class Splitting {
 public:
    explicit Splitting(double max_edge_px) : max_edge_px_(static_cast<float>(max_edge_px)) {}

    void add(const FacePolygon& polygon, std::uint32_t number) {
        const auto first = static_cast<std::uint32_t>(coarse_.pixels.size());
        coarse_.pixels.insert(coarse_.pixels.end(), polygon.corners_px.begin(),
                              polygon.corners_px.end());
        const auto end = static_cast<std::uint32_t>(coarse_.pixels.size());
        for (std::uint32_t k = first + 1; k + 1 < end; ++k) split({{first, k, k + 1}, number});
    }

    [[nodiscard]] CoarseTriangles take() { return std::move(coarse_); }

 private:
    void split(const CoarseTriangles::Triangle& triangle) {
        const auto [a, b, c] = triangle.corners;
        const Eigen::Vector2d& at_a = coarse_.pixels[a];
        const Eigen::Vector2d& at_b = coarse_.pixels[b];
        const Eigen::Vector2d& at_c = coarse_.pixels[c];
        const auto [shortest, longest] = std::minmax(
            {edge_length_px(at_a, at_b), edge_length_px(at_b, at_c), edge_length_px(at_c, at_a)});
        if (!(shortest > max_edge_px_) || is_flat(at_b - at_a, at_c - at_a, longest))
            return coarse_.triangles.push_back(triangle);
        const std::uint32_t ab = middle(a, b);
        const std::uint32_t bc = middle(b, c);
        const std::uint32_t ca = middle(c, a);
        for (const auto& corners : {std::array{a, ab, ca}, std::array{ab, bc, ca},
                                    std::array{ab, b, bc}, std::array{ca, bc, c}})
            split({corners, triangle.polygon});
    }

    [[nodiscard]] std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t edge = edges_.number_of(a, b);
        if (edge == middles_.size()) {
            middles_.push_back(static_cast<std::uint32_t>(coarse_.pixels.size()));
            coarse_.pixels.emplace_back(0.5 * (coarse_.pixels[a] + coarse_.pixels[b]));
        }
        return middles_[edge];
    }

    float max_edge_px_;
    CoarseTriangles coarse_;
    EdgeTable edges_;
    std::vector<std::uint32_t> middles_;  ///< Of the edges, by their numbers.
};

}  // namespace

CoarseTriangles coarse_triangles(const std::vector<FacePolygon>& polygons, double max_edge_px) {
    Splitting splitting(max_edge_px);
    for (std::uint32_t i = 0; i < polygons.size(); ++i) splitting.add(polygons[i], i);
    return splitting.take();
}

}  // namespace lumi
