#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "calib/capture/camera.h"
#include "calib/work/config_section.h"
#include "pipeline/synth/hand_held_path.h"
#include "pipeline/synth/photographer.h"
#include "pipeline/synth/scene.h"
#include "pipeline/synth/sensor.h"

namespace lumi {

/// A scene and how it is photographed: what `lumi synth` reads.
struct SceneDescription {
    std::uint64_t seed = 1;
    Camera camera;
    HandHeldPath path;
    Scene scene;
    SamplingOptions sampling;
    SensorOptions sensor;
    int truth_points = 2000;    ///< Exact scene points with tracks. >= 0.
    std::string resolved_toml;  ///< The same description with every default filled in.
};

/// Throws Error (E-CONFIG-...) with file, line and key, for unknown keys too.
[[nodiscard]] SceneDescription read_scene_description(const ConfigSection& root);
[[nodiscard]] SceneDescription read_scene_description(const std::filesystem::path& toml);

/// configs/demo-scene.toml, as it was when lumi was built.
[[nodiscard]] std::string_view demo_scene_toml();

/// A solid of a body; `shape` decides which other keys are known.
[[nodiscard]] Solid read_solid(const ConfigSection& section);

}  // namespace lumi
