#include "meshing/matching/window_match.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "meshing/matching/similarity_by_difference.h"
#include "meshing/warp/instruction_sets.h"

namespace lumi {
namespace {

static_assert(kWindowSamples == 16 && kWindowRadius == 3);

// Sixteen values at a time, in as many registers as the machine needs for them. Operators work
// value by value, so that results are the same on every machine.
using Floats [[gnu::vector_size(64)]] = float;
using Ints [[gnu::vector_size(64)]] = int;

constexpr Floats kOffsetX = {-3, -1, 1, 3, -3, -1, 1, 3, -3, -1, 1, 3, -3, -1, 1, 3};
constexpr Floats kOffsetY = {-3, -3, -3, -3, -1, -1, -1, -1, 1, 1, 1, 1, 3, 3, 3, 3};

/// Sum in a fixed order.
[[gnu::always_inline]] inline float sum_of(const Floats& values) {
    float partial[8];
    for (int i = 0; i < 8; ++i) partial[i] = values[i] + values[i + 8];
    for (int i = 0; i < 4; ++i) partial[i] += partial[i + 4];
    return (partial[0] + partial[2]) + (partial[1] + partial[3]);
}

/// Grey values of a picture at (u, v), bilinear; beyond the border those of the border.
[[gnu::always_inline]] inline void sample(const PackedPicture& picture, Floats& u, Floats& v,
                                          Floats& gray) {
    const float max_u = static_cast<float>(picture.width - 1);
    const float max_v = static_cast<float>(picture.height - 1);
    u = u > 0.0F ? u : Floats{};
    v = v > 0.0F ? v : Floats{};
    u = u < max_u ? u : Floats{} + max_u;
    v = v < max_v ? v : Floats{} + max_v;
    const Ints column = __builtin_convertvector(u, Ints);
    const Ints row = __builtin_convertvector(v, Ints);
    const Floats right = u - __builtin_convertvector(column, Floats);
    const Floats down = v - __builtin_convertvector(row, Floats);
    const Ints index = row * picture.width + column;
    const std::uint32_t* quads = picture.quads.data();
    Ints quad;
    for (int i = 0; i < 16; ++i) quad[i] = static_cast<int>(quads[index[i]]);
    const Floats a = __builtin_convertvector(quad & 255, Floats);
    const Floats b = __builtin_convertvector((quad >> 8) & 255, Floats);
    const Floats c = __builtin_convertvector((quad >> 16) & 255, Floats);
    const Floats d = __builtin_convertvector((quad >> 24) & 255, Floats);
    const Floats upper = a + right * (b - a);
    const Floats lower = c + right * (d - c);
    gray = upper + down * (lower - upper);
}

struct WindowCosts {
    LUMI_KERNEL void run(const ReferenceWindow* window, const ComparedView* views,
                         std::size_t count, float x, float y, const PixelPlane* plane,
                         float* costs) {
        constexpr float kLeastVariance = 0.25F;  // Grey levels squared: rounding to bytes.
        Floats weights, normalised;
        for (int i = 0; i < 16; ++i) {
            weights[i] = window->weights[static_cast<std::size_t>(i)];
            normalised[i] = window->normalised[static_cast<std::size_t>(i)];
        }
        const Floats along = plane->right * kOffsetX + plane->down * kOffsetY;
        for (std::size_t k = 0; k < count; ++k) {
            const auto& h = views[k].homography;
            const auto& e = views[k].epipole;
            const float q = plane->inverse_depth;
            const float centre_x = h[0] * x + h[1] * y + h[2] + q * e[0];
            const float centre_y = h[3] * x + h[4] * y + h[5] + q * e[1];
            const float centre_z = h[6] * x + h[7] * y + h[8] + q * e[2];
            const PackedPicture& picture = views[k].picture;
            const bool inside = centre_z > 0 && centre_x >= 0 && centre_y >= 0 &&
                                centre_x < centre_z * static_cast<float>(picture.width) &&
                                centre_y < centre_z * static_cast<float>(picture.height);
            const Floats z = centre_z + h[6] * kOffsetX + h[7] * kOffsetY + along * e[2];
            const Floats scale = 1.0F / (z > 1e-9F ? z : Floats{} + 1e-9F);
            Floats u = (centre_x + h[0] * kOffsetX + h[1] * kOffsetY + along * e[0]) * scale - 0.5F;
            Floats v = (centre_y + h[3] * kOffsetX + h[4] * kOffsetY + along * e[1]) * scale - 0.5F;
            Floats gray;
            sample(picture, u, v, gray);
            const float mean = sum_of(weights * gray);
            const float square = sum_of(weights * gray * gray);
            const float product = sum_of(normalised * gray);
            const float deviation = __builtin_sqrtf(std::max(square - mean * mean, kLeastVariance));
            costs[k] = inside ? 1.0F - product / deviation : kWindowUnseen;
        }
    }
};

}  // namespace

ReferenceWindow reference_window(const GrayImage& gray, int x, int y) {
    constexpr float kLeastDeviation = 1.5F;
    constexpr double kSimilarGray = 18.0;
    static const std::array<float, 256> similarity = similarity_by_difference(kSimilarGray);
    ReferenceWindow window;
    std::array<float, kWindowSamples> values{};
    const int centre = gray(x, y);
    float total = 0;
    std::size_t next = 0;
    for (int dy = -kWindowRadius; dy <= kWindowRadius; dy += 2) {
        for (int dx = -kWindowRadius; dx <= kWindowRadius; dx += 2, ++next) {
            const int value = gray(std::clamp(x + dx, 0, gray.width() - 1),
                                   std::clamp(y + dy, 0, gray.height() - 1));
            values[next] = static_cast<float>(value);
            window.weights[next] = similarity[static_cast<std::size_t>(std::abs(value - centre))];
            total += window.weights[next];
        }
    }
    float mean = 0;
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
        window.weights[i] /= total;
        mean += window.weights[i] * values[i];
    }
    float variance = 0;
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
        variance += window.weights[i] * (values[i] - mean) * (values[i] - mean);
    }
    const float deviation = std::sqrt(variance);
    window.has_texture = deviation >= kLeastDeviation;
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
        window.normalised[i] =
            window.has_texture ? window.weights[i] * (values[i] - mean) / deviation : 0.0F;
    }
    return window;
}

ComparedView compared_view(const InverseDepthWarp& warp, const GrayImage& gray) {
    ComparedView view{{}, {}, packed(gray)};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            view.homography[static_cast<std::size_t>(3 * row + column)] =
                static_cast<float>(warp.infinite_homography(row, column));
        }
        view.epipole[static_cast<std::size_t>(row)] = static_cast<float>(warp.epipole(row));
    }
    return view;
}

void window_costs(const ReferenceWindow& window, const std::vector<ComparedView>& views, int x,
                  int y, const PixelPlane& plane, float* costs) {
    run_fastest<WindowCosts>(&window, views.data(), views.size(), static_cast<float>(x) + 0.5F,
                             static_cast<float>(y) + 0.5F, &plane, costs);
}

}  // namespace lumi
