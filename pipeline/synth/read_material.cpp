#include <array>
#include <string>

#include "pipeline/synth/material.h"
#include "pipeline/synth/read_vectors.h"

namespace lumi {
namespace {

struct PatternEntry {
    Pattern pattern;
    std::string_view name;
};

constexpr std::array<PatternEntry, 6> kPatterns{{
    {Pattern::kStone, "stone"},
    {Pattern::kMarble, "marble"},
    {Pattern::kWood, "wood"},
    {Pattern::kPlanks, "planks"},
    {Pattern::kBricks, "bricks"},
    {Pattern::kGlaze, "glaze"},
}};

}  // namespace

std::string_view name_of(Pattern pattern) {
    for (const PatternEntry& entry : kPatterns) {
        if (entry.pattern == pattern) return entry.name;
    }
    return {};
}

std::optional<Pattern> pattern_named(std::string_view name) {
    for (const PatternEntry& entry : kPatterns) {
        if (entry.name == name) return entry.pattern;
    }
    return std::nullopt;
}

Material read_material(const ConfigSection& section, std::uint32_t seed) {
    Material material;
    material.seed = seed;
    material.name = section.text("name", "");
    if (material.name.empty()) section.refuse("name", "a name that bodies can ask for");
    const auto pattern =
        pattern_named(section.text("pattern", std::string(name_of(material.pattern))));
    if (!pattern) section.refuse("pattern", "stone, marble, wood, planks, bricks or glaze");
    material.pattern = *pattern;
    material.colors = read_colors(section, "colors", material.colors);
    material.feature_size = read_positive(section, "feature_size", material.feature_size);
    material.detail_contrast = section.number("detail_contrast", material.detail_contrast);
    if (material.detail_contrast < 0 || material.detail_contrast > 1) {
        section.refuse("detail_contrast", "a number from 0 to 1");
    }
    material.detail_size = read_positive(section, "detail_size", material.detail_size);
    material.gloss = read_not_negative(section, "gloss", material.gloss);
    return material;
}

}  // namespace lumi
