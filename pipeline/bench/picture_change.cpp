#include "pipeline/bench/picture_change.h"

#include <cstdlib>

namespace lumi {
namespace {

/// `difference` of the i-th pixel's channel, averaged over all.
template <class Difference>
double mean_over_channels(const ColorImage& picture, const Difference& difference) {
    double sum = 0;
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        sum += std::abs(difference(i, &Rgb8::r)) + std::abs(difference(i, &Rgb8::g)) +
               std::abs(difference(i, &Rgb8::b));
    return sum / (3.0 * static_cast<double>(picture.pixels().size()));
}

}  // namespace

double change(const ColorImage& a, const ColorImage& a_before) {
    return mean_over_channels(a, [&](std::size_t i, auto channel) {
        return a.pixels()[i].*channel - a_before.pixels()[i].*channel;
    });
}

double unlike_change(const ColorImage& a, const ColorImage& a_before, const ColorImage& b,
                     const ColorImage& b_before) {
    return mean_over_channels(a, [&](std::size_t i, auto channel) {
        return (a.pixels()[i].*channel - a_before.pixels()[i].*channel) -
               (b.pixels()[i].*channel - b_before.pixels()[i].*channel);
    });
}

}  // namespace lumi
