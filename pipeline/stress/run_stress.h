#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "calib/work/config_section.h"
#include "calib/work/progress.h"
#include "pipeline/stress/perturbation.h"
#include "pipeline/stress/stress_result.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What is tried, and on what.
struct StressOptions {
    std::vector<RenderMode> modes;  ///< Empty: all that there are.
    std::vector<Perturbation> perturbations;
    std::uint64_t seed = 1;
    double max_loss_db = 3.0;  ///< What counts as broken.
};

/// The table [stress] of a configuration:
///
///     [stress]
///     seed = 1
///     modes = ["perpixel"]                    # default: all
///     max_loss_db = 3.0                       # where the breaking point lies
///     perturbations = ["blur_px"]             # default: all
///     blur_px = [0.5, 1, 2, 4]                # strengths, above 0 and rising
///
/// Throws Error (E-CONFIG-...).
[[nodiscard]] StressOptions read_stress_options(const ConfigSection& section);

/// A photograph to compare with, and where it was taken.
struct StressView {
    std::string name;
    Eye eye;
    ColorImage photograph;
    double falloff = 0.0;  ///< Of the lens (light_left.h): in the photograph, and not in drawings.
};

/// What is perturbed, and what it is compared with.
struct StressSubject {
    Lumigraph lumigraph;
    std::vector<StressView> views = {};
    bool views_are_held_out = true;
    CameraMeshOptions mesh_options = {};  ///< Its camera mesh was built with these.
};

/// Perturbs the Lumigraph in every way and draws the views in every mode. The figures are the same
/// in every run. Throws Error (E-GL-...).
[[nodiscard]] std::vector<StressCurve> stress_curves(const StressSubject& subject,
                                                     const StressOptions& options,
                                                     Progress& progress);

}  // namespace lumi
