#include "meshing/depth/edge_aware_fill.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "meshing/depth/guided_smoothing.h"

namespace lumi {
namespace {

constexpr std::size_t kDirections = 8;
constexpr std::array<std::array<int, 2>, kDirections> kSteps{
    {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}}};

/// The nearest known pixel in one direction.
struct Candidate {
    float inverse_depth = 0.0F;
    float distance_px = 0.0F;  ///< 0: none.
};
using CandidateImage = Image<Candidate>;

CandidateImage nearest_known(const DepthMap& map, std::array<int, 2> step) {
    const int width = map.inverse_depth.width();
    const int height = map.inverse_depth.height();
    const float length = step[0] != 0 && step[1] != 0 ? 1.41421356F : 1.0F;
    const bool backwards = step[1] > 0 || (step[1] == 0 && step[0] > 0);
    CandidateImage candidates(width, height);
    const int pixels = width * height;
    for (int i = 0; i < pixels; ++i) {
        const int index = backwards ? pixels - 1 - i : i;
        const int x = index % width;
        const int y = index / width;
        const int from_x = x + step[0];
        const int from_y = y + step[1];
        if (!map.confidence.contains(from_x, from_y)) continue;
        if (map.confidence(from_x, from_y) != 0) {
            candidates(x, y) = {map.inverse_depth(from_x, from_y), length};
        } else if (const Candidate& from = candidates(from_x, from_y); from.distance_px > 0) {
            candidates(x, y) = {from.inverse_depth, from.distance_px + length};
        }
    }
    return candidates;
}

/// The candidate that stands for the background: the second farthest, so that one wrong pixel does
/// not rule; the farthest of two.
Candidate background_of(std::span<const Candidate> found) {
    Candidate farthest = found[0];
    Candidate second = found[0];
    for (std::size_t i = 1; i < found.size(); ++i) {
        if (found[i].inverse_depth < farthest.inverse_depth) {
            second = farthest;
            farthest = found[i];
        } else if (i == 1 || found[i].inverse_depth < second.inverse_depth) {
            second = found[i];
        }
    }
    return found.size() >= 3 ? second : farthest;
}

/// Mean of the candidates that continue the background.
float background_mean(std::span<const Candidate> found, float one_pixel) {
    // A surface that recedes by a third of a pixel per pixel is still one surface.
    constexpr float kSlope = 0.33F;
    const Candidate background = background_of(found);
    float sum = 0;
    float weights = 0;
    for (const Candidate& candidate : found) {
        const float allowed =
            one_pixel * (1 + kSlope * (candidate.distance_px + background.distance_px));
        if (candidate.inverse_depth > background.inverse_depth + allowed) continue;
        sum += candidate.inverse_depth / candidate.distance_px;
        weights += 1 / candidate.distance_px;
    }
    return sum / weights;
}

void fill_from_background(DepthMap& map, const FloatImage& fallback, float one_pixel) {
    std::vector<CandidateImage> by_direction;
    for (const auto& step : kSteps) by_direction.push_back(nearest_known(map, step));
    for (std::size_t i = 0; i < map.confidence.pixels().size(); ++i) {
        if (map.confidence.pixels()[i] != 0) continue;
        std::array<Candidate, kDirections> found;
        std::size_t count = 0;
        for (const CandidateImage& candidates : by_direction) {
            const Candidate& candidate = candidates.pixels()[i];
            if (candidate.distance_px > 0) found[count++] = candidate;
        }
        map.inverse_depth.pixels()[i] =
            count == 0 ? fallback.pixels()[i]
                       : background_mean(std::span(found).first(count), one_pixel);
    }
}

/// Smooths what was filled along the photograph's edges; what is known holds its place.
void smooth_filled(DepthMap& map, const ColorImage& photograph) {
    constexpr float kFilledWeight = 0.1F;
    FloatImage weights(map.confidence.width(), map.confidence.height());
    std::transform(map.confidence.pixels().begin(), map.confidence.pixels().end(),
                   weights.pixels().begin(),
                   [](std::uint8_t confidence) { return confidence != 0 ? 1.0F : kFilledWeight; });
    const FloatImage smooth = smooth_guided(map.inverse_depth, weights, photograph, {});
    for (std::size_t i = 0; i < smooth.pixels().size(); ++i) {
        if (map.confidence.pixels()[i] == 0) map.inverse_depth.pixels()[i] = smooth.pixels()[i];
    }
}

}  // namespace

void edge_aware_fill(DepthMap& map, const ColorImage& photograph, const FloatImage& fallback,
                     double one_pixel) {
    const auto& confidence = map.confidence.pixels();
    if (std::find(confidence.begin(), confidence.end(), 0) == confidence.end()) return;
    fill_from_background(map, fallback, static_cast<float>(one_pixel));
    smooth_filled(map, photograph);
}

}  // namespace lumi
