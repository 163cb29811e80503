#include "pipeline/stages/color_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lumi {
namespace {

constexpr std::array<Rgb8, 9> kSamples{{{0, 34, 78},
                                        {28, 52, 110},
                                        {61, 74, 108},
                                        {91, 96, 110},
                                        {124, 123, 120},
                                        {148, 142, 119},
                                        {184, 171, 104},
                                        {219, 202, 82},
                                        {254, 232, 56}}};

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, float share) {
    const float a = static_cast<float>(from);
    const float b = static_cast<float>(to);
    return static_cast<std::uint8_t>(std::lround(a + (b - a) * share));
}

}  // namespace

Rgb8 color_of_share(float share) {
    const float position = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(kSamples.size() - 1);
    const auto index = std::min(static_cast<std::size_t>(position), kSamples.size() - 2);
    const float rest = position - static_cast<float>(index);
    const Rgb8& from = kSamples[index];
    const Rgb8& to = kSamples[index + 1];
    return {mixed(from.r, to.r, rest), mixed(from.g, to.g, rest), mixed(from.b, to.b, rest)};
}

}  // namespace lumi
