#pragma once

#include <numbers>

namespace lumi {

inline constexpr double kRadiansPerDegree = std::numbers::pi / 180;

}  // namespace lumi
