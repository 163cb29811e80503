#pragma once

#include <filesystem>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/evaluate/view_curve.h"

namespace lumi {

/// Draws the curve into the folder: what is lost in dB (loss.svg, beside random choices with their
/// standard deviation), MiB (mib.svg) and ms (ms.svg) against the number of views. Returns their
/// paths. Throws what plot_svg throws, and E-FILE-WRITE.
std::vector<std::filesystem::path> draw_view_curve(const std::filesystem::path& folder,
                                                   const ViewCurve& curve,
                                                   const Progress& progress);

}  // namespace lumi
