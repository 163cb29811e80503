#include "meshing/exposure/light_falloff.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "calib/capture/light_left.h"
#include "calib/work/cauchy_scale.h"
#include "calib/work/median.h"
#include "meshing/selection/one_standard_error.h"

namespace lumi {
namespace {

constexpr int kFalloffRounds = 10;
constexpr std::size_t kLeastFalloffTiles = 4;  // Of a pair, of one colour.
constexpr int kLeastTellingPairs = 6;
constexpr double kLeastScale = 0.005;  // Of the logarithm of light: below that all is rounding.
constexpr double kLargestTileError = 0.25;  // A tile that is further off is no worse.
constexpr double kFalloffNoiseFactor = 2.0;
/// Surfaces that shine deceive, and may do so either way: of one capture the corners seem to be
/// brighter by as much (chair), which is no lens's doing; of a scene without any falloff they seem
/// to be darker by a quarter of it.
constexpr double kLeastCornerLoss = 0.08;
constexpr double kLeastCornerLight = 1.0 / 8;

/// The tiles of one colour that a pair of views shares: how much brighter, all channels together,
/// and their levers.
struct PairTiles {
    std::vector<double> log_ratios;
    std::vector<double> levers;
};

std::vector<PairTiles> tiles_of_fold(const std::vector<SharedTiles>& pairs, std::size_t fold) {
    std::vector<PairTiles> result;
    for (const SharedTiles& pair : pairs) {
        PairTiles of_pair;
        for (const SharedTile& tile : pair.tiles) {
            if (tile.fold != fold) continue;
            of_pair.log_ratios.push_back(tile.log_ratio.mean());
            of_pair.levers.push_back(tile.lever);
        }
        result.push_back(std::move(of_pair));
    }
    return result;
}

/// Takes the weighted mean from the values.
void centre(const std::vector<double>& weights, std::vector<double>& values) {
    double sum = 0;
    double of_weights = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += weights[i] * values[i];
        of_weights += weights[i];
    }
    for (double& value : values) value -= sum / of_weights;
}

using TileWeights = std::vector<std::vector<double>>;  ///< Of the tiles of each pair.

/// What tiles of each pair say beyond what its exposures do.
std::vector<PairTiles> about_their_means(std::vector<PairTiles> pairs, const TileWeights& weights) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        centre(weights[k], pairs[k].log_ratios);
        centre(weights[k], pairs[k].levers);
    }
    return pairs;
}

/// Least squares; 0 where no tile tells it.
double slope_of(const std::vector<PairTiles>& centred, const TileWeights& weights) {
    double products = 0;
    double squares = 0;
    for (std::size_t k = 0; k < centred.size(); ++k) {
        const std::vector<double>& levers = centred[k].levers;
        if (levers.size() < kLeastFalloffTiles) continue;
        for (std::size_t i = 0; i < levers.size(); ++i) {
            products += weights[k][i] * levers[i] * centred[k].log_ratios[i];
            squares += weights[k][i] * levers[i] * levers[i];
        }
    }
    return squares > 0 ? products / squares : 0;
}

/// By how far each tile is off: robust (Cauchy).
TileWeights weights_for_tiles(const std::vector<PairTiles>& centred, double falloff) {
    std::vector<double> all_off;
    TileWeights weights;
    for (const PairTiles& pair : centred) {
        std::vector<double>& off = weights.emplace_back();
        for (std::size_t i = 0; i < pair.levers.size(); ++i)
            off.push_back(std::abs(pair.log_ratios[i] - falloff * pair.levers[i]));
        all_off.insert(all_off.end(), off.begin(), off.end());
    }
    const double sigma = kSigmaPerMedianOff * median_of(all_off);
    const double scale = kCauchyScalePerSigma * std::max(kLeastScale, sigma);
    for (std::vector<double>& of_pair : weights)
        for (double& weight : of_pair) weight = 1 / (1 + std::pow(weight / scale, 2));
    return weights;
}

double fitted_falloff(const std::vector<PairTiles>& pairs) {
    TileWeights weights;
    for (const PairTiles& pair : pairs) weights.emplace_back(pair.levers.size(), 1.0);
    double falloff = 0;
    for (int round = 0; round < kFalloffRounds; ++round) {
        const std::vector<PairTiles> centred = about_their_means(pairs, weights);
        falloff = slope_of(centred, weights);
        weights = weights_for_tiles(centred, falloff);
    }
    return falloff;
}

/// How much the tiles of each pair still differ from each other, squared.
std::vector<double> differences_left(const std::vector<PairTiles>& pairs, double falloff) {
    std::vector<double> errors;
    for (const PairTiles& pair : pairs) {
        std::vector<double> left;
        for (std::size_t i = 0; i < pair.levers.size(); ++i)
            left.push_back(pair.log_ratios[i] - falloff * pair.levers[i]);
        double sum = 0;
        if (left.size() >= kLeastFalloffTiles) {
            const double middle = median_of(left);
            for (const double value : left)
                sum += std::pow(std::min(std::abs(value - middle), kLargestTileError), 2);
            sum /= static_cast<double>(left.size());
        }
        errors.push_back(sum);
    }
    return errors;
}

/// What is left when each colour is asked with the falloff of the other.
std::vector<double> differences_left(const std::array<std::vector<PairTiles>, 2>& folds,
                                     const std::array<double, 2>& falloffs) {
    std::vector<double> errors = differences_left(folds[0], falloffs[1]);
    const std::vector<double> second = differences_left(folds[1], falloffs[0]);
    for (std::size_t i = 0; i < errors.size(); ++i) errors[i] += second[i];
    return errors;
}

bool is_better(const std::vector<double>& with, const std::vector<double>& without,
               std::size_t view_count) {
    const Excess excess = excess_over(without, with);
    return excess.mean > standard_error_over_views(excess, with.size(), view_count);
}

/// Pairs that have tiles enough of both colours.
int telling_pairs(const std::array<std::vector<PairTiles>, 2>& folds) {
    int count = 0;
    for (std::size_t k = 0; k < folds[0].size(); ++k) {
        if (std::min(folds[0][k].levers.size(), folds[1][k].levers.size()) >= kLeastFalloffTiles)
            ++count;
    }
    return count;
}

double least_light_left(double falloff, const std::vector<PicturedView>& views) {
    double least = 1;
    for (const PicturedView& view : views)
        least = std::min(least, light_left_in_corner(falloff, view.camera));
    return least;
}

}  // namespace

double light_falloff(const std::vector<PicturedView>& views,
                     const std::vector<SharedTiles>& pairs) {
    const std::array<std::vector<PairTiles>, 2> folds{tiles_of_fold(pairs, 0),
                                                      tiles_of_fold(pairs, 1)};
    if (telling_pairs(folds) < kLeastTellingPairs) return 0;
    const std::array<double, 2> falloffs{fitted_falloff(folds[0]), fitted_falloff(folds[1])};
    const double falloff = 0.5 * (falloffs[0] + falloffs[1]);
    const double noise = 0.5 * std::abs(falloffs[0] - falloffs[1]);
    const double left = least_light_left(falloff, views);
    const bool is_told = -falloff > kFalloffNoiseFactor * noise && left <= 1 - kLeastCornerLoss &&
                         left >= kLeastCornerLight &&
                         is_better(differences_left(folds, falloffs),
                                   differences_left(folds, {0.0, 0.0}), views.size());
    return is_told ? falloff : 0;
}

}  // namespace lumi
