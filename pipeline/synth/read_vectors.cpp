#include "pipeline/synth/read_vectors.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

namespace lumi {
namespace {

std::optional<LinearColor> parsed_color(const std::string& text) {
    if (text.size() != 7 || text.front() != '#') return std::nullopt;
    Eigen::Vector3f srgb;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const char* first = text.data() + 1 + 2 * channel;
        int value = 0;
        const auto [end, status] = std::from_chars(first, first + 2, value, 16);
        if (status != std::errc{} || end != first + 2 || value < 0) return std::nullopt;
        srgb[static_cast<Eigen::Index>(channel)] = static_cast<float>(value) / 255.0f;
    }
    return linear_from_srgb(srgb);
}

std::string color_text(const LinearColor& color) {
    const Eigen::Vector3f srgb = srgb_from_linear(color) * 255.0f;
    char text[8];
    std::snprintf(text, sizeof text, "#%02lx%02lx%02lx",
                  static_cast<unsigned long>(std::lround(srgb[0])),
                  static_cast<unsigned long>(std::lround(srgb[1])),
                  static_cast<unsigned long>(std::lround(srgb[2])));
    return text;
}

}  // namespace

Eigen::Vector3d read_vector(const ConfigSection& section, const std::string& key,
                            const Eigen::Vector3d& fallback) {
    const std::vector<double> values =
        section.numbers(key, {fallback.x(), fallback.y(), fallback.z()});
    if (values.size() != 3) section.refuse(key, "three numbers");
    return {values[0], values[1], values[2]};
}

double read_positive(const ConfigSection& section, const std::string& key, double fallback) {
    const double value = section.number(key, fallback);
    if (!(value > 0)) section.refuse(key, "a number above 0");
    return value;
}

double read_not_negative(const ConfigSection& section, const std::string& key, double fallback) {
    const double value = section.number(key, fallback);
    if (value < 0) section.refuse(key, "0 or more");
    return value;
}

LinearColor read_color(const ConfigSection& section, const std::string& key,
                       const LinearColor& fallback) {
    const auto color = parsed_color(section.text(key, color_text(fallback)));
    if (!color) section.refuse(key, "a colour such as \"#c8b89a\"");
    return *color;
}

std::array<LinearColor, 3> read_colors(const ConfigSection& section, const std::string& key,
                                       const std::array<LinearColor, 3>& fallback) {
    std::vector<std::string> texts;
    for (const LinearColor& color : fallback) texts.push_back(color_text(color));
    texts = section.texts(key, texts);
    if (texts.size() != 3) section.refuse(key, "three colours");
    std::array<LinearColor, 3> colors;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto color = parsed_color(texts[i]);
        if (!color) section.refuse(key, "colours such as \"#c8b89a\"");
        colors[i] = *color;
    }
    return colors;
}

}  // namespace lumi
