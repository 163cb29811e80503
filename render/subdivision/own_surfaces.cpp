#include "render/subdivision/own_surfaces.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace lumi {
namespace {

constexpr std::size_t kViews = 3;

/// One triangle, as it was.
class Triangle {
 public:
    Triangle(const BlendTriangles& triangles, std::size_t first_index)
        : corners_{corner(triangles, first_index), corner(triangles, first_index + 1),
                   corner(triangles, first_index + 2)} {}

    [[nodiscard]] bool has_guess() const {
        return std::any_of(corners_.begin(), corners_.end(), [](const BlendVertex* corner) {
            return corner->confidence < kSeenByOne;
        });
    }

    [[nodiscard]] float weight(std::size_t corner, std::size_t k) const {
        return weight_of_photograph(k, *corners_[corner]);
    }

    /// Where photograph k counts, if it does at some corners and not at others.
    [[nodiscard]] std::optional<double> own_inverse_depth(std::size_t k) const {
        double inverse_depth = 0;
        double sum = 0;
        bool counts_everywhere = true;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto at = static_cast<double>(weight(corner, k));
            inverse_depth += at * static_cast<double>(corners_[corner]->inverse_depth);
            sum += at;
            counts_everywhere = counts_everywhere && at > 0;
        }
        if (counts_everywhere || sum <= 0) return std::nullopt;
        return inverse_depth / sum;
    }

    [[nodiscard]] double longest_edge_at(std::size_t corner) const {
        const Eigen::Vector2d pixel = vector_of(corners_[corner]->pixel);
        double longest = 0;
        for (const BlendVertex* other : corners_)
            longest = std::max(longest, (vector_of(other->pixel) - pixel).norm());
        return longest;
    }

 private:
    static const BlendVertex* corner(const BlendTriangles& triangles, std::size_t index) {
        return &triangles.vertices[triangles.indices[index]];
    }

    std::array<const BlendVertex*, 3> corners_;
};

/// The corner with photograph k looked up at this depth. False, and nothing changes, where it is
/// behind the camera, or no farther off than the triangle is long: that is no sweep.
bool look_up_at(double inverse_depth, std::size_t k, double longest_edge_px,
                const DepthSearch& search, BlendVertex& corner) {
    const auto in_view =
        search.line_in(static_cast<int>(corner.view_layers[k]), vector_of(corner.pixel))
            .at(inverse_depth);
    if (!in_view) return false;
    const Eigen::Vector2d& own = in_view->pixel;
    if ((own - vector_of(corner.view_pixels[k])).norm() <= longest_edge_px) return false;
    corner.view_pixels[k] = {static_cast<float>(own.x()), static_cast<float>(own.y())};
    corner.depth_ratios[k] = static_cast<float>(in_view->depth_ratio);
    return true;
}

}  // namespace

void keep_own_surfaces(const DepthSearch& search, BlendTriangles& triangles) {
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        const Triangle triangle(triangles, i);
        if (!triangle.has_guess()) continue;
        std::array<std::optional<double>, kViews> own;
        for (std::size_t k = 0; k < kViews; ++k) own[k] = triangle.own_inverse_depth(k);
        if (own == std::array<std::optional<double>, kViews>{}) continue;
        std::array<std::optional<BlendVertex>, 3> changed;
        for (std::size_t c = 0; c < 3; ++c) {
            BlendVertex corner = triangles.vertices[triangles.indices[i + c]];
            bool is_changed = false;
            for (std::size_t k = 0; k < kViews; ++k)
                if (own[k] && triangle.weight(c, k) == 0.0F &&
                    look_up_at(*own[k], k, triangle.longest_edge_at(c), search, corner))
                    is_changed = true;
            if (is_changed) changed[c] = corner;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            if (!changed[c]) continue;
            triangles.indices[i + c] = static_cast<std::uint32_t>(triangles.vertices.size());
            triangles.vertices.push_back(*changed[c]);
        }
    }
}

}  // namespace lumi
