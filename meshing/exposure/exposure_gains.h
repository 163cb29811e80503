#pragma once

#include <array>
#include <string>
#include <vector>

#include "meshing/exposure/exposure_ratios.h"

namespace lumi {

/// What photographs of one capture may differ by.
enum class ExposureModel {
    kNone,          ///< Nothing that can be told from noise.
    kGain,          ///< Exposure: one factor a photograph.
    kChannelGains,  ///< White balance as well: a factor for each channel.
};
[[nodiscard]] std::string name_of(ExposureModel model);

/// Factors that bring photographs into one exposure, and what speaks for them.
struct ExposureGains {
    ExposureModel model = ExposureModel::kNone;
    /// Of each photograph's light, red, green and blue; their geometric mean over the photographs
    /// is 1. All 1 for ExposureModel::kNone.
    std::vector<std::array<double, 3>> gains;
    /// Of each photograph, 0 or 1: whether its gains tell white balance. Where they do not, for it
    /// is black and white among others that are not, it has one for all channels.
    std::vector<char> tell_white_balance;
    int pairs = 0;  ///< Of views that share enough to be compared.
    /// Root mean square of the logarithm (base 2) of what pairs differ by, before and after.
    double difference_stops = 0.0;
    double remaining_stops = 0.0;
    double largest_stops = 0.0;  ///< Of the gains.
};

/// The gains that explain the ratios: least squares of the logarithms with a prior of half a stop
/// about 1 (after Brown and Lowe 2007, section 6), robust by iterated Cauchy weights. A pair counts
/// the more the better its tiles agree: where light falls on a turned object or surfaces shine,
/// ratios are no exposures, and the prior keeps them from adding up around it.
///
/// The model is the simplest that the richest cannot be told from: each is fitted to one colour of
/// the chequerboard (exposure_ratios.h) and asked for the other; it is as good when its squared
/// error exceeds the least by no more than one standard error (Breiman et al. 1984), over the pairs
/// or, with fewer than three, over their tiles. Gains that are
/// less than twice what the two fits differ by, or less than half an 8-bit step of a mid grey (1 %
/// of its light), are none; and so are those that leave more than 15 % of what pairs differ
/// by, in the median and in the root mean square: then it is not exposure that they mostly differ
/// by, but how surfaces shine. Views that no ratio speaks of keep gain 1.
[[nodiscard]] ExposureGains exposure_gains(int view_count,
                                           const std::vector<ExposureRatio>& ratios);

}  // namespace lumi
