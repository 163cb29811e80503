#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/frame/frame.h"

namespace lumi {

/// What one mode loses to one perturbation.
struct StressCurve {
    std::string perturbation;  ///< Its name.
    RenderMode mode = RenderMode::kPerPixel;
    std::vector<double> strengths;  ///< 0 first: nothing perturbed.
    std::vector<double> psnr_db;    ///< Mean over the views that are compared with.
    /// The least strength at which `StressResult::max_loss_db` is lost, interpolated; empty when
    /// that is not reached.
    std::optional<double> breaking_point;
};

struct StressResult {
    std::string name;
    std::string package_sha256;  ///< Of the manifest.
    std::uint64_t seed = 0;
    double max_loss_db = 3.0;
    std::vector<std::string> views;  ///< What is compared with.
    bool views_are_held_out = true;  ///< False: their depth knew the photographs.
    std::vector<StressCurve> curves;
};

/// The strength at which a falling curve has lost `max_loss_db` against its first value.
[[nodiscard]] std::optional<double> breaking_point_of(const StressCurve& curve, double max_loss_db);

}  // namespace lumi
