#include "meshing/filling/guided_smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "meshing/exposure/color_match.h"
#include "meshing/matching/similarity_by_difference.h"
#include "meshing/warp/instruction_sets.h"

namespace lumi {
namespace {

constexpr std::size_t kBandRows = 16;

/// How much two neighbours hold together, by the difference of their guide.
class EdgeWeights {
 public:
    explicit EdgeWeights(double sigma) : table_(similarity_by_difference(sigma)) {}
    [[nodiscard]] float between(const Rgb8& a, const Rgb8& b) const {
        return table_[static_cast<std::size_t>(largest_difference(a, b))];
    }

 private:
    std::array<float, 256> table_;
};

// Lines are solved side by side: position i of `lanes` lines lies in `lanes` floats in a row, so
// that one step along all lines is a loop that vectorises.

/// One step of the elimination, from the positions before to these. `upper` holds the eliminated
/// coefficients above the diagonal.
[[gnu::always_inline]] inline void eliminate(
    std::size_t lanes, float lambda, const float* __restrict hold_before,
    const float* __restrict hold_after, const float* __restrict upper_before,
    const float* __restrict value_before, const float* __restrict weight_before,
    float* __restrict upper, float* __restrict value, float* __restrict weight) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const float before = lambda * hold_before[lane];
        const float after = lambda * hold_after[lane];
        const float scale = 1.0F / (1.0F + before + after + before * upper_before[lane]);
        upper[lane] = -after * scale;
        value[lane] = (value[lane] + before * value_before[lane]) * scale;
        weight[lane] = (weight[lane] + before * weight_before[lane]) * scale;
    }
}

[[gnu::always_inline]] inline void substitute(std::size_t lanes, const float* __restrict upper,
                                              const float* __restrict value_next,
                                              const float* __restrict weight_next,
                                              float* __restrict value, float* __restrict weight) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        value[lane] -= upper[lane] * value_next[lane];
        weight[lane] -= upper[lane] * weight_next[lane];
    }
}

/// Solves the tridiagonal systems of `lanes` lines of `length` positions (Thomas's algorithm).
/// `holds` tells how each position holds together with the next; those of the last are zero.
/// `zeros` are `lanes` zeros.
struct SolveLines {
    LUMI_KERNEL void run(std::size_t lanes, std::size_t length, float lambda, const float* zeros,
                         const float* holds, float* upper, float* values, float* weights) {
        eliminate(lanes, lambda, zeros, holds, zeros, zeros, zeros, upper, values, weights);
        for (std::size_t i = 1; i < length; ++i) {
            const std::size_t at = i * lanes;
            const std::size_t before = at - lanes;
            eliminate(lanes, lambda, holds + before, holds + at, upper + before, values + before,
                      weights + before, upper + at, values + at, weights + at);
        }
        for (std::size_t i = length - 1; i-- > 0;) {
            const std::size_t at = i * lanes;
            substitute(lanes, upper + at, values + at + lanes, weights + at + lanes, values + at,
                       weights + at);
        }
    }
};

/// What is smoothed: weighted values and weights go through the same equations.
class Smoother {
 public:
    Smoother(const FloatImage& values, const FloatImage& weights, const ColorImage& guide,
             double sigma)
        : width_(static_cast<std::size_t>(values.width())),
          height_(static_cast<std::size_t>(values.height())),
          weighted_(values.pixels()),
          weight_(weights.pixels()),
          upper_(weighted_.size()),
          holds_below_(weighted_.size(), 0.0F),
          holds_right_(bands() * kBandRows * width_, 0.0F),
          band_values_(kBandRows * width_),
          band_weights_(band_values_),
          band_upper_(band_values_),
          zeros_(std::max(width_, kBandRows), 0.0F) {
        for (std::size_t i = 0; i < weighted_.size(); ++i) weighted_[i] *= weight_[i];
        take_holds(guide, EdgeWeights(sigma));
    }

    void smooth(float lambda) {
        for (std::size_t band = 0; band < bands(); ++band) solve_band(band, lambda);
        run_fastest<SolveLines>(width_, height_, lambda, zeros_.data(), holds_below_.data(),
                                upper_.data(), weighted_.data(), weight_.data());
    }

    [[nodiscard]] float weighted(std::size_t i) const { return weighted_[i]; }
    [[nodiscard]] float weight(std::size_t i) const { return weight_[i]; }

 private:
    [[nodiscard]] std::size_t bands() const { return (height_ + kBandRows - 1) / kBandRows; }
    [[nodiscard]] std::size_t rows_of(std::size_t band) const {
        return std::min(kBandRows, height_ - band * kBandRows);
    }

    void take_holds(const ColorImage& guide, const EdgeWeights& edges) {
        for (std::size_t y = 0; y < height_; ++y) {
            const Rgb8* row = guide.row(static_cast<int>(y));
            float* right = &holds_right_[y / kBandRows * kBandRows * width_ + y % kBandRows];
            for (std::size_t x = 0; x + 1 < width_; ++x) {
                right[x * kBandRows] = edges.between(row[x], row[x + 1]);
            }
            if (y + 1 == height_) break;
            const Rgb8* below = guide.row(static_cast<int>(y) + 1);
            for (std::size_t x = 0; x < width_; ++x) {
                holds_below_[y * width_ + x] = edges.between(row[x], below[x]);
            }
        }
    }

    /// Some rows, turned on their side so that they can be solved side by side.
    void solve_band(std::size_t band, float lambda) {
        const std::size_t rows = rows_of(band);
        const std::size_t first = band * kBandRows * width_;
        for (std::size_t row = 0; row < rows; ++row) {
            for (std::size_t x = 0; x < width_; ++x) {
                band_values_[x * kBandRows + row] = weighted_[first + row * width_ + x];
                band_weights_[x * kBandRows + row] = weight_[first + row * width_ + x];
            }
        }
        run_fastest<SolveLines>(kBandRows, width_, lambda, zeros_.data(), &holds_right_[first],
                                band_upper_.data(), band_values_.data(), band_weights_.data());
        for (std::size_t row = 0; row < rows; ++row) {
            for (std::size_t x = 0; x < width_; ++x) {
                weighted_[first + row * width_ + x] = band_values_[x * kBandRows + row];
                weight_[first + row * width_ + x] = band_weights_[x * kBandRows + row];
            }
        }
    }

    std::size_t width_;
    std::size_t height_;
    std::vector<float> weighted_;
    std::vector<float> weight_;
    std::vector<float> upper_;
    std::vector<float> holds_below_;
    std::vector<float> holds_right_;  ///< Band by band, turned like the bands.
    std::vector<float> band_values_;
    std::vector<float> band_weights_;
    std::vector<float> band_upper_;
    std::vector<float> zeros_;
};

}  // namespace

FloatImage smooth_guided(const FloatImage& values, const FloatImage& weights,
                         const ColorImage& guide, const GuidedSmoothing& options) {
    FloatImage result = values;
    if (values.empty()) return result;
    Smoother smoother(values, weights, guide, options.sigma);
    for (int iteration = 1; iteration <= options.iterations; ++iteration) {
        // Falling strength keeps streaks of the alternation away (Min et al. 2014, eq. 18).
        const double share = 1.5 * std::pow(4.0, options.iterations - iteration) /
                             (std::pow(4.0, options.iterations) - 1.0);
        smoother.smooth(static_cast<float>(share * options.lambda));
    }
    for (std::size_t i = 0; i < result.pixels().size(); ++i) {
        if (smoother.weight(i) <= 0) continue;
        result.pixels()[i] = smoother.weighted(i) / smoother.weight(i);
    }
    return result;
}

}  // namespace lumi
