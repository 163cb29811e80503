#include "pipeline/synth/scene_description.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "pipeline/synth/read_vectors.h"

namespace lumi {
namespace {

Camera read_camera(const ConfigSection& section) {
    const int width_px = section.integer("width_px", 960);
    const int height_px = section.integer("height_px", 640);
    for (const char* key : {"width_px", "height_px"}) {
        if (const int size = section.integer(key, 640); size < 8 || size > 16384) {
            section.refuse(key, "8 to 16384");
        }
    }
    const double focal_px = read_positive(section, "focal_length_px", width_px);
    const auto model = lens_model_named(section.text("lens_model", "PINHOLE"));
    if (!model) section.refuse("lens_model", "one of COLMAP's names, such as \"SIMPLE_RADIAL\"");

    const bool one_focal_length = *model == LensModel::kSimplePinhole ||
                                  *model == LensModel::kSimpleRadial ||
                                  *model == LensModel::kRadial;
    Camera camera{width_px, height_px, *model, {focal_px}};
    if (!one_focal_length) camera.parameters.push_back(focal_px);
    camera.parameters.push_back(0.5 * width_px);
    camera.parameters.push_back(0.5 * height_px);
    const std::size_t terms = parameter_count(*model) - camera.parameters.size();
    const std::vector<double> distortion =
        section.numbers("distortion", std::vector<double>(terms, 0.0));
    if (distortion.size() != terms) {
        section.refuse("distortion", std::to_string(terms) + " numbers for this lens model");
    }
    camera.parameters.insert(camera.parameters.end(), distortion.begin(), distortion.end());
    return camera;
}

Lighting read_lighting(const ConfigSection& section) {
    Lighting lighting;
    lighting.towards_lamp = read_vector(section, "towards_lamp", lighting.towards_lamp);
    if (lighting.towards_lamp.isZero()) section.refuse("towards_lamp", "a direction");
    lighting.lamp_color = read_color(section, "lamp_color", lighting.lamp_color) *
                          static_cast<float>(read_not_negative(section, "lamp_strength", 1.0));
    lighting.sky_color = read_color(section, "sky_color", lighting.sky_color);
    lighting.ground_color = read_color(section, "ground_color", lighting.ground_color);
    lighting.lamp_softness = read_positive(section, "lamp_softness", lighting.lamp_softness);
    lighting.contact_radius = read_not_negative(section, "contact_radius", lighting.contact_radius);
    return lighting;
}

int material_index_of(const ConfigSection& section, const std::vector<Material>& materials) {
    const std::string name = section.text("material", "");
    const auto named =
        std::find_if(materials.begin(), materials.end(),
                     [&](const Material& material) { return material.name == name; });
    if (named == materials.end()) section.refuse("material", "the name of a [[material]]");
    return static_cast<int>(named - materials.begin());
}

/// Solids that do not flow together become bodies of their own, which are faster to hit.
void append_bodies(const ConfigSection& section, Scene& scene) {
    const std::string name = section.text("name", "");
    const int material_index = material_index_of(section, scene.materials);
    const double blend = read_not_negative(section, "blend", 0.0);
    const bool casts_shadow = section.boolean("casts_shadow", true);
    std::vector<Solid> solids;
    for (const ConfigSection& solid : section.sections("solids")) {
        solids.push_back(read_solid(solid));
    }
    if (solids.empty()) section.refuse("solids", "at least one solid");
    if (solids.size() > kMaxSolidsPerBody) {
        section.refuse("solids", "at most " + std::to_string(kMaxSolidsPerBody) + " solids");
    }
    if (blend > 0.0) {
        scene.bodies.emplace_back(name, material_index, std::move(solids), blend, casts_shadow);
        return;
    }
    for (const Solid& solid : solids) {
        scene.bodies.emplace_back(name, material_index, std::vector{solid}, blend, casts_shadow);
    }
}

Scene read_scene(const ConfigSection& root, std::uint64_t seed) {
    Scene scene;
    scene.lighting = read_lighting(root.section("light"));
    for (const ConfigSection& section : root.sections("material")) {
        const auto index = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back(
            read_material(section, static_cast<std::uint32_t>(seed) + 1000u * index));
    }
    for (const ConfigSection& section : root.sections("body")) {
        append_bodies(section, scene);
    }
    return scene;
}

}  // namespace

SamplingOptions read_sampling_options(const ConfigSection& section) {
    const auto read_samples = [&](const char* key, int fallback) {
        const int samples = section.integer(key, fallback);
        if (samples < 1 || samples > 64) section.refuse(key, "1 to 64");
        return samples;
    };
    SamplingOptions options;
    options.samples_per_texture = read_samples("samples_per_texture", options.samples_per_texture);
    options.samples_per_edge = read_samples("samples_per_edge", options.samples_per_edge);
    return options;
}

SceneDescription read_scene_description(const ConfigSection& root) {
    SceneDescription description;
    const int seed = root.integer("seed", 1);
    if (seed < 0) root.refuse("seed", "0 or more");
    description.seed = static_cast<std::uint64_t>(seed);
    description.camera = read_camera(root.section("camera"));
    description.path = read_hand_held_path(root.section("path"));
    description.sampling = read_sampling_options(root.section("sampling"));
    description.sensor = read_sensor_options(root.section("sensor"));
    const ConfigSection truth = root.section("truth");
    description.truth_points = truth.integer("points", description.truth_points);
    if (description.truth_points < 0) truth.refuse("points", "0 or more");
    description.scene = read_scene(root, description.seed);
    root.expect_all_keys_known();  // Before what is misspelt is found to be missing.
    if (description.scene.bodies.empty()) root.refuse("body", "at least one [[body]]");
    description.resolved_toml = root.resolved();
    return description;
}

SceneDescription read_scene_description(const std::filesystem::path& toml) {
    return read_scene_description(ConfigSection::from_file(toml));
}

}  // namespace lumi
