#include "render/subdivision/thin_triangles.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "calib/capture/inverse_depth_warp.h"
#include "calib/work/parallel_for.h"
#include "render/transfer/polygon_extent.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {
namespace {

constexpr int kMostViews = 3;
/// So far beside the eye's picture triangles are still drawn, as shares of its size.
constexpr float kBeside = 0.25F;
/// Something that the view sees so far before a point hides it, and is no error of depth.
constexpr double kHides_px = 2.0;
constexpr std::size_t kThinAtATime = 64;

/// Of a triangle.
struct Middle {
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    double inverse_depth = 0.0;
};

/// Thin surfaces of one view in the eye's picture.
class ThinPicture {
 public:
    ThinPicture(const Lumigraph& lumigraph, int view_index, const ThinSurfaces& thin,
                const Eye& eye)
        : view_index_(view_index),
          thin_(thin),
          size_px_(eye.camera.width_px, eye.camera.height_px) {
        const LumigraphView& view = lumigraph.views[static_cast<std::size_t>(view_index)];
        const InverseDepthWarp eye_from_view = warp_from(view).to(eye);
        corners_.reserve(thin.vertices.size());
        for (const Eigen::Vector3f& vertex : thin.vertices)
            corners_.push_back(corner_at(vertex.cast<double>(), eye_from_view));
    }

    [[nodiscard]] std::size_t count() const { return thin_.indices.size() / 3; }
    [[nodiscard]] int view_index() const { return view_index_; }
    [[nodiscard]] const BlendVertex& corner(std::size_t triangle, std::size_t k) const {
        return corners_[thin_.indices[3 * triangle + k]];
    }

    /// Before the eye, and not far beside its picture.
    [[nodiscard]] bool is_in_picture(std::size_t triangle) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const BlendVertex& at = corner(triangle, k);
            const Eigen::Array2f share =
                Eigen::Array2f(at.pixel[0], at.pixel[1]) / size_px_.cast<float>();
            if (at.weights[0] <= 0 || share.minCoeff() < -kBeside || share.maxCoeff() > 1 + kBeside)
                return false;
        }
        return true;
    }

    [[nodiscard]] Middle middle_of(std::size_t triangle) const {
        Middle middle;
        for (std::size_t k = 0; k < 3; ++k) {
            middle.pixel += vector_of(corner(triangle, k).pixel) / 3;
            middle.inverse_depth += static_cast<double>(corner(triangle, k).inverse_depth) / 3;
        }
        return middle;
    }

 private:
    /// Without weight where it lies behind the eye.
    [[nodiscard]] BlendVertex corner_at(const Eigen::Vector3d& vertex,
                                        const InverseDepthWarp& eye_from_view) const {
        const auto in_eye = eye_from_view.at(vertex.head<2>(), vertex.z());
        BlendVertex corner;
        corner.view_layers.fill(static_cast<float>(view_index_));
        if (!in_eye || in_eye->depth_ratio <= kLeastDepthRatio) return corner;
        corner.pixel = {static_cast<float>(in_eye->pixel.x()),
                        static_cast<float>(in_eye->pixel.y())};
        corner.depth = static_cast<float>(in_eye->depth_ratio);
        corner.view_pixels.fill({static_cast<float>(vertex.x()), static_cast<float>(vertex.y())});
        corner.depth_ratios.fill(static_cast<float>(1 / in_eye->depth_ratio));
        corner.weights = {1.0F, 0.0F, 0.0F};
        corner.inverse_depth = static_cast<float>(in_eye->inverse_depth);
        corner.confidence = 1.0F;
        return corner;
    }

    int view_index_;
    const ThinSurfaces& thin_;
    Eigen::Array2i size_px_;
    std::vector<BlendVertex> corners_;
};

/// Whether a view that comes first has a say: it has the place in its photograph, and nothing
/// hides it there.
bool is_for_view(int view_index, const Middle& middle, const DepthSearch& search) {
    const auto at = search.line_in(view_index, middle.pixel).at(middle.inverse_depth);
    return at && search.inside(view_index, at->pixel) > 0 &&
           search.hidden_by_px(middle.pixel, middle.inverse_depth, view_index) < kHides_px;
}

bool is_hidden(const Middle& middle, const std::array<int, 3>& asked, const DepthSearch& search) {
    const auto hit = search.first_hit(middle.pixel, asked);
    return hit && hit->kind == DepthKind::kSeen &&
           search.is_before(*hit, {.inverse_depth = middle.inverse_depth});
}

/// One that is drawn, by its place among those of the picture that it is part of.
struct Drawn {
    std::size_t picture;
    std::size_t triangle;
    double inverse_depth;
    double doubled_area_px2;
};

double doubled_area_of(const ThinPicture& picture, std::size_t triangle) {
    const Eigen::Vector2d a = vector_of(picture.corner(triangle, 0).pixel);
    return doubled_area_px2(vector_of(picture.corner(triangle, 1).pixel) - a,
                            vector_of(picture.corner(triangle, 2).pixel) - a);
}

void keep_largest(std::size_t most, std::vector<Drawn>& drawn) {
    if (most == 0 || drawn.size() <= most) return;
    std::stable_sort(drawn.begin(), drawn.end(), [](const Drawn& a, const Drawn& b) {
        return a.doubled_area_px2 > b.doubled_area_px2;
    });
    drawn.resize(most);
}

/// The farthest first.
BlendTriangles sorted(const std::vector<ThinPicture>& pictures, std::vector<Drawn> drawn) {
    std::stable_sort(drawn.begin(), drawn.end(), [](const Drawn& a, const Drawn& b) {
        return a.inverse_depth < b.inverse_depth;
    });
    BlendTriangles triangles;
    for (const Drawn& one : drawn) {
        for (std::size_t k = 0; k < 3; ++k) {
            triangles.indices.push_back(static_cast<std::uint32_t>(triangles.vertices.size()));
            triangles.vertices.push_back(pictures[one.picture].corner(one.triangle, k));
        }
    }
    return triangles;
}

}  // namespace

BlendTriangles thin_triangles(const Lumigraph& lumigraph, const SearchedViews& views,
                              const Eye& eye, const DepthSearch& search, std::size_t most) {
    const std::vector<int> chosen = choose_depth_views(lumigraph, eye, kMostViews);
    const std::array<int, 3> asked = three_with_repeats(chosen);
    std::vector<ThinPicture> pictures;
    std::vector<Drawn> drawn;
    for (const int view : chosen) {
        pictures.emplace_back(lumigraph, view, views.thin[static_cast<std::size_t>(view)], eye);
        const ThinPicture& picture = pictures.back();
        const auto are_others = [&](const Middle& middle) {
            return std::any_of(pictures.begin(), pictures.end() - 1, [&](const ThinPicture& other) {
                return is_for_view(other.view_index(), middle, search);
            });
        };
        std::vector<char> is_drawn(picture.count(), 0);
        parallel_for_runs(
            picture.count(), kThinAtATime, 0, [&](std::size_t first, std::size_t end) {
                for (std::size_t t = first; t < end; ++t) {
                    if (!picture.is_in_picture(t)) continue;
                    const Middle middle = picture.middle_of(t);
                    is_drawn[t] = !are_others(middle) && !is_hidden(middle, asked, search) ? 1 : 0;
                }
            });
        for (std::size_t t = 0; t < picture.count(); ++t)
            if (is_drawn[t] != 0)
                drawn.push_back({pictures.size() - 1, t, picture.middle_of(t).inverse_depth,
                                 doubled_area_of(picture, t)});
    }
    keep_largest(most, drawn);
    return sorted(pictures, std::move(drawn));
}

}  // namespace lumi
