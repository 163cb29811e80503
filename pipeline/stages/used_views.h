#pragma once

#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "pipeline/config/build_config.h"

namespace lumi {

/// In the order of the views.
[[nodiscard]] std::vector<std::string> view_names(const Capture& capture);

/// Names of the photographs that are held out, sorted. `every` counts photographs in order of name,
/// whether or not their pose was found. Throws Error (E-EVAL-NAME) when a listed name is not among
/// the photographs.
[[nodiscard]] std::vector<std::string> held_out_names(
    const std::vector<std::string>& photograph_names, const HoldOutOptions& options);

/// The capture without the held-out views, so that no later stage can look at them: their
/// observations go with them, and so do points that fewer than two of the other views see. Points
/// that came without a track are kept.
[[nodiscard]] PosedPhotographs without_views(const PosedPhotographs& photographs,
                                             const std::vector<std::string>& held_out);

/// The named views alone, in the same sense.
[[nodiscard]] PosedPhotographs only_views(const PosedPhotographs& photographs,
                                          const std::vector<std::string>& names);

}  // namespace lumi
