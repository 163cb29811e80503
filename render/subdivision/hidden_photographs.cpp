#include "render/subdivision/hidden_photographs.h"

#include <algorithm>
#include <cstddef>

namespace lumi {
namespace {

/// What stands less before the corner may be noise, and photographs are better blended then.
constexpr double kLeastBefore_px = 16.0;
/// A photograph that would count less, were it not hidden, does not count on that side of the face.
constexpr double kLeastRayWeight = 0.01;

constexpr std::size_t kViews = 3;

/// Of photograph k; where a face names a camera twice, of all that are the same.
template <class Weights>
double weight_of(std::size_t k, const Weights& weights, const FacePolygon& polygon) {
    double sum = 0;
    for (std::size_t other = 0; other < kViews; ++other)
        if (polygon.view_indices[other] == polygon.view_indices[k])
            sum += static_cast<double>(weights[other]);
    return sum;
}

bool is_hidden_from(std::size_t k, const BlendVertex& corner, const PatchSampler& sampler) {
    const FacePolygon& polygon = sampler.polygon();
    const Eigen::Vector2d pixel = vector_of(corner.pixel);
    return weight_of(k, corner.weights, polygon) <= 0 &&
           weight_of(k, weights_at(polygon, pixel), polygon) > kLeastRayWeight &&
           sampler.search().hidden_by_px(pixel, static_cast<double>(corner.inverse_depth),
                                         polygon.view_indices[k]) >= kLeastBefore_px;
}

}  // namespace

std::array<bool, 3> hidden_photographs(const PatchSampler& sampler,
                                       const std::array<const BlendVertex*, 3>& corners) {
    std::array<bool, kViews> is_hidden{};
    bool does_one_count_everywhere = false;
    for (std::size_t k = 0; k < kViews; ++k) {
        const auto counting =
            std::count_if(corners.begin(), corners.end(), [&](const auto* corner) {
                return weight_of(k, corner->weights, sampler.polygon()) > 0;
            });
        if (counting == 3) does_one_count_everywhere = true;
        is_hidden[k] = (counting == 1 || counting == 2) &&
                       std::any_of(corners.begin(), corners.end(), [&](const auto* corner) {
                           return is_hidden_from(k, *corner, sampler);
                       });
    }
    return does_one_count_everywhere ? is_hidden : std::array<bool, kViews>{};
}

BlendVertex without(const std::array<bool, 3>& photographs, BlendVertex corner) {
    float left = 0;
    for (std::size_t k = 0; k < kViews; ++k) {
        if (photographs[k]) corner.weights[k] = 0;
        left += corner.weights[k];
    }
    for (float& weight : corner.weights) weight /= left;
    return corner;
}

}  // namespace lumi
