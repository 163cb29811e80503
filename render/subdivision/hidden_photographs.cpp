#include "render/subdivision/hidden_photographs.h"

#include <algorithm>
#include <cstddef>

#include "render/depth_search/occlusion.h"

namespace lumi {
namespace {

/// A photograph that would count less, were it not hidden, does not count on that side of the face.
constexpr float kLeastRayWeight = 0.01F;

constexpr std::size_t kViews = 3;

/// The corner as if nothing hid it from any photograph.
BlendVertex unhidden(BlendVertex corner, const FacePolygon& polygon) {
    const std::array<double, kViews> of_ray = weights_at(polygon, vector_of(corner.pixel));
    for (std::size_t k = 0; k < kViews; ++k) corner.weights[k] = static_cast<float>(of_ray[k]);
    return corner;
}

bool is_hidden_from(std::size_t k, const BlendVertex& corner, const PatchSampler& sampler) {
    return weight_of_photograph(k, corner) <= 0 &&
           weight_of_photograph(k, unhidden(corner, sampler.polygon())) > kLeastRayWeight &&
           sampler.search().hidden_by_px(vector_of(corner.pixel),
                                         static_cast<double>(corner.inverse_depth),
                                         sampler.polygon().view_indices[k]) >= kSurelyBefore_px;
}

/// Most triangles are of this kind.
bool count_all_everywhere(const std::array<const BlendVertex*, 3>& corners) {
    return std::all_of(corners.begin(), corners.end(), [](const BlendVertex* corner) {
        return corner->weights[0] > 0 && corner->weights[1] > 0 && corner->weights[2] > 0;
    });
}

/// At how many corners it counts.
std::size_t counting_corners(std::size_t k, const std::array<const BlendVertex*, 3>& corners) {
    return static_cast<std::size_t>(std::count_if(
        corners.begin(), corners.end(),
        [&](const BlendVertex* corner) { return weight_of_photograph(k, *corner) > 0; }));
}

/// Whether it shows something else within the triangle.
bool is_hidden_between(std::size_t k, const std::array<const BlendVertex*, 3>& corners,
                       const PatchSampler& sampler) {
    Footprint footprint;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        if (corners[c]->depth_ratios[k] <= 0) return false;
        footprint.corners[c] = vector_of(corners[c]->view_pixels[k]);
        footprint.inverse_depths[static_cast<Eigen::Index>(c)] =
            static_cast<double>(corners[c]->inverse_depth / corners[c]->depth_ratios[k]);
    }
    return sampler.search().is_part_hidden(footprint, kSurelyBefore_px,
                                           sampler.polygon().view_indices[k]);
}

}  // namespace

std::array<bool, 3> hidden_photographs(const PatchSampler& sampler,
                                       const std::array<const BlendVertex*, 3>& corners) {
    std::array<bool, kViews> is_hidden{};
    const bool may_show_thin = sampler.search().has_thin();
    if (!may_show_thin && count_all_everywhere(corners)) return is_hidden;
    bool does_one_see_all = false;
    for (std::size_t k = 0; k < kViews; ++k) {
        const std::size_t counting = counting_corners(k, corners);
        if (counting == 0) continue;
        const bool is_corner_hidden =
            counting < corners.size() &&
            std::any_of(corners.begin(), corners.end(), [&](const BlendVertex* corner) {
                return is_hidden_from(k, *corner, sampler);
            });
        is_hidden[k] =
            is_corner_hidden || (may_show_thin && is_hidden_between(k, corners, sampler));
        does_one_see_all = does_one_see_all || (counting == corners.size() && !is_hidden[k]);
    }
    return does_one_see_all ? is_hidden : std::array<bool, kViews>{};
}

BlendVertex without(const std::array<bool, 3>& photographs, BlendVertex corner) {
    std::array<double, kViews> weights{};
    std::array<double, kViews> visibility{};
    for (std::size_t k = 0; k < kViews; ++k) {
        weights[k] = static_cast<double>(corner.weights[k]);
        visibility[k] = photographs[k] ? 0.0 : 1.0;
    }
    if (const auto left = redistributed(weights, visibility))
        for (std::size_t k = 0; k < kViews; ++k) corner.weights[k] = static_cast<float>((*left)[k]);
    return corner;
}

}  // namespace lumi
