#include "meshing/depth/guided_smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace lumi {
namespace {

/// How much two neighbours hold together, by the difference of their guide.
class EdgeWeights {
 public:
    EdgeWeights(const ColorImage& guide, double sigma) : guide_(guide) {
        for (std::size_t difference = 0; difference < table_.size(); ++difference) {
            table_[difference] =
                static_cast<float>(std::exp(-static_cast<double>(difference) / sigma));
        }
    }
    [[nodiscard]] float between(int x, int y, int other_x, int other_y) const {
        const Rgb8& a = guide_(x, y);
        const Rgb8& b = guide_(other_x, other_y);
        const int difference =
            std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        return table_[static_cast<std::size_t>(difference)];
    }

 private:
    const ColorImage& guide_;
    std::array<float, 256> table_{};
};

/// What is smoothed: weighted values and weights go through the same equations.
struct Homogeneous {
    FloatImage weighted;
    FloatImage weight;
};

/// One step of the elimination: pixel (x, y) after (from_x, from_y). `upper` holds the eliminated
/// coefficients of the row above the diagonal.
void eliminate(Homogeneous& u, FloatImage& upper, int x, int y, int from_x, int from_y,
               float before, float after) {
    const float scale = 1.0F / (1.0F + before + after + before * upper(from_x, from_y));
    upper(x, y) = -after * scale;
    u.weighted(x, y) = (u.weighted(x, y) + before * u.weighted(from_x, from_y)) * scale;
    u.weight(x, y) = (u.weight(x, y) + before * u.weight(from_x, from_y)) * scale;
}

void begin(Homogeneous& u, FloatImage& upper, int x, int y, float after) {
    const float scale = 1.0F / (1.0F + after);
    upper(x, y) = -after * scale;
    u.weighted(x, y) *= scale;
    u.weight(x, y) *= scale;
}

void substitute(Homogeneous& u, const FloatImage& upper, int x, int y, int next_x, int next_y) {
    u.weighted(x, y) -= upper(x, y) * u.weighted(next_x, next_y);
    u.weight(x, y) -= upper(x, y) * u.weight(next_x, next_y);
}

/// Solves every row's tridiagonal system, or every column's for (dx, dy) = (0, 1), by Thomas's
/// algorithm. Both walk the picture row by row.
void solve_lines(Homogeneous& u, FloatImage& upper, const EdgeWeights& edges, float lambda, int dx,
                 int dy) {
    const int width = u.weight.width();
    const int height = u.weight.height();
    const auto hold = [&](int x, int y) {  // To the next pixel of the line; 0 at its end.
        if (!u.weight.contains(x + dx, y + dy)) return 0.0F;
        return lambda * edges.between(x, y, x + dx, y + dy);
    };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (u.weight.contains(x - dx, y - dy)) {
                eliminate(u, upper, x, y, x - dx, y - dy, hold(x - dx, y - dy), hold(x, y));
            } else {
                begin(u, upper, x, y, hold(x, y));
            }
        }
    }
    for (int y = height - 1; y >= 0; --y) {
        for (int x = width - 1; x >= 0; --x) {
            if (u.weight.contains(x + dx, y + dy)) substitute(u, upper, x, y, x + dx, y + dy);
        }
    }
}

}  // namespace

FloatImage smooth_guided(const FloatImage& values, const FloatImage& weights,
                         const ColorImage& guide, const GuidedSmoothing& options) {
    Homogeneous u{values, weights};
    for (std::size_t i = 0; i < values.pixels().size(); ++i) {
        u.weighted.pixels()[i] *= weights.pixels()[i];
    }
    FloatImage upper(values.width(), values.height());
    const EdgeWeights edges(guide, options.sigma);
    for (int iteration = 1; iteration <= options.iterations; ++iteration) {
        // Falling strength keeps streaks of the alternation away (Min et al. 2014, eq. 18).
        const double share = 1.5 * std::pow(4.0, options.iterations - iteration) /
                             (std::pow(4.0, options.iterations) - 1.0);
        const auto lambda = static_cast<float>(share * options.lambda);
        solve_lines(u, upper, edges, lambda, 1, 0);
        solve_lines(u, upper, edges, lambda, 0, 1);
    }
    FloatImage result = values;
    for (std::size_t i = 0; i < values.pixels().size(); ++i) {
        if (u.weight.pixels()[i] <= 0) continue;
        result.pixels()[i] = u.weighted.pixels()[i] / u.weight.pixels()[i];
    }
    return result;
}

}  // namespace lumi
