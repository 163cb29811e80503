#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/config/build_config.h"
#include "render/frame/frame.h"

namespace lumi {

/// A setting and what is tried for it.
struct SweepAxis {
    std::string setting;              ///< As in the configuration: "depth.model".
    std::vector<std::string> values;  ///< As words: "sparse", "768".
};

/// One combination of settings; packages are made for each, and drawn in every mode.
struct Variant {
    std::vector<std::size_t> choice;  ///< For each axis the index of its value.
    std::string label;                ///< The values alone: "sparse 768".
    BuildConfig config;
};

/// What a chart compares: the [sweep] table of a configuration,
///
///     [sweep]
///     modes = ["perpixel", "lightfield"]     # default: all that there are
///     repeats = 2                            # of every stage, for the spread of its time
///     depth.model = ["sparse", "sweep"]      # any setting of the configuration: a list;
///                                            # ["all"]: every depth model there is
///     capture.max_width_px = [384, 768]
///
/// or, without one, the default sweep: the depth models and three image sizes.
struct Sweep {
    std::string name;
    std::vector<SweepAxis> axes;
    std::vector<Variant> variants;  ///< All combinations, the last axis changing fastest.
    std::vector<RenderMode> modes;
    int repeats = 1;
    bool is_default = false;  ///< The configuration says nothing of what to try.
};

/// Throws Error: E-CONFIG-... naming file and key (also what a setting of the sweep is told), and
/// E-CHART-SIZE for more than 1000 combinations.
[[nodiscard]] Sweep read_sweep(const std::filesystem::path& file_or_folder);

}  // namespace lumi
