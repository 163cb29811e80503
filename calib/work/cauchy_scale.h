#pragma once

namespace lumi {

/// The scale of Cauchy's loss, in standard deviations of the noise, at which it is nearly as good
/// as least squares where noise is Gaussian (95 %: Holland and Welsch, Robust regression using
/// iteratively reweighted least-squares, 1977).
inline constexpr double kCauchyScalePerSigma = 2.385;

}  // namespace lumi
