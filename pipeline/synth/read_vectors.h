#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "calib/work/config_section.h"
#include "pipeline/synth/material.h"

namespace lumi {

/// Values of a scene's description that take more than one number. All throw Error
/// (E-CONFIG-VALUE) with file, line and key.

[[nodiscard]] Eigen::Vector3d read_vector(const ConfigSection& section, const std::string& key,
                                          const Eigen::Vector3d& fallback);
[[nodiscard]] double read_positive(const ConfigSection& section, const std::string& key,
                                   double fallback);
[[nodiscard]] double read_not_negative(const ConfigSection& section, const std::string& key,
                                       double fallback);
/// "#rrggbb" in sRGB.
[[nodiscard]] LinearColor read_color(const ConfigSection& section, const std::string& key,
                                     const LinearColor& fallback);
/// Three of them.
[[nodiscard]] std::array<LinearColor, 3> read_colors(const ConfigSection& section,
                                                     const std::string& key,
                                                     const std::array<LinearColor, 3>& fallback);

}  // namespace lumi
