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

/// At how many corners it counts.
std::size_t counting_corners(std::size_t k, const std::array<const BlendVertex*, 3>& corners,
                             const FacePolygon& polygon) {
    return static_cast<std::size_t>(std::count_if(
        corners.begin(), corners.end(),
        [&](const BlendVertex* corner) { return weight_of(k, corner->weights, polygon) > 0; }));
}

/// Most triangles are of this kind.
bool count_all_everywhere(const std::array<const BlendVertex*, 3>& corners) {
    return std::all_of(corners.begin(), corners.end(), [](const BlendVertex* corner) {
        return corner->weights[0] > 0 && corner->weights[1] > 0 && corner->weights[2] > 0;
    });
}

}  // namespace

std::array<bool, 3> hidden_photographs(const PatchSampler& sampler,
                                       const std::array<const BlendVertex*, 3>& corners) {
    std::array<bool, kViews> is_hidden{};
    if (count_all_everywhere(corners)) return is_hidden;
    std::array<std::size_t, kViews> counting{};
    for (std::size_t k = 0; k < kViews; ++k)
        counting[k] = counting_corners(k, corners, sampler.polygon());
    if (std::count(counting.begin(), counting.end(), corners.size()) == 0) return is_hidden;
    for (std::size_t k = 0; k < kViews; ++k)
        is_hidden[k] = counting[k] > 0 && counting[k] < corners.size() &&
                       std::any_of(corners.begin(), corners.end(), [&](const auto* corner) {
                           return is_hidden_from(k, *corner, sampler);
                       });
    return is_hidden;
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
