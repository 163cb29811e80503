#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "calib/work/config_section.h"

namespace lumi {

/// How a material's colours are laid out in space.
enum class Pattern {
    kStone,   ///< Clouds of two colours with speckles of the third.
    kMarble,  ///< Veins of the second and third colour in the first.
    kWood,    ///< Rings about the material's axis, with grain along it.
    kPlanks,  ///< Boards of wood side by side.
    kBricks,  ///< Bricks between the first two colours, mortar of the third.
    kGlaze,   ///< Painted bands one above the other.
};

[[nodiscard]] std::string_view name_of(Pattern pattern);
[[nodiscard]] std::optional<Pattern> pattern_named(std::string_view name);

/// Linear light, red green blue.
using LinearColor = Eigen::Vector3f;

[[nodiscard]] LinearColor linear_from_srgb(const Eigen::Vector3f& srgb);
/// Clamps to [0, 1] first.
[[nodiscard]] Eigen::Vector3f srgb_from_linear(const LinearColor& linear);

/// A solid texture: colour is a function of the place in the world, never of the viewer.
struct Material {
    std::string name;
    Pattern pattern = Pattern::kStone;
    std::array<LinearColor, 3> colors{LinearColor::Constant(0.6f), LinearColor::Constant(0.4f),
                                      LinearColor::Constant(0.2f)};
    double feature_size = 0.1;  ///< Of a cloud, vein, ring, board, brick or band; world units. > 0.
    double detail_contrast = 0.3;  ///< Of the fine noise over everything. [0, 1].
    double detail_size = 0.02;     ///< Of its largest grain, world units. > 0.
    double gloss = 0.0;            ///< Strength of the highlight. >= 0.
    std::uint32_t seed = 0;
    /// The pattern repeats itself so many times around the world's z axis, sector by sector as
    /// surfaces face: a box around the axis looks the same from so many sides. >= 1.
    int copies_around = 1;
};

/// The share of light that is reflected at a place, averaged over a sample of size `footprint`
/// (world units).
[[nodiscard]] LinearColor albedo_at(const Material& material, const Eigen::Vector3d& point_in_world,
                                    const Eigen::Vector3d& normal, double footprint);

/// Throws Error (E-CONFIG-...) with file, line and key.
[[nodiscard]] Material read_material(const ConfigSection& section, std::uint32_t seed);

}  // namespace lumi
