#include "calib/doctor/match_graph_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "calib/work/formatted.h"
#include "calib/work/svg_escaped.h"

namespace lumi {
namespace {

constexpr double kSide = 760;
constexpr double kRadius = 270;
constexpr double kFootline = 40;
/// Above this many photographs, only every other, third ... name is written.
constexpr std::size_t kMaxNames = 48;
constexpr const char* kGeneral = "#2f6fb0";
constexpr const char* kFlat = "#e08a2a";
constexpr const char* kAlone = "#aaaaaa";
constexpr std::array<const char*, 5> kGroupColors{"#1b3a5c", "#8e44ad", "#2e8b57", "#b03a2e",
                                                  "#7d6608"};

/// Names keep their end: that is where they differ.
std::string short_name(const std::string& name) {
    constexpr std::size_t kMaxBytes = 18;
    if (name.size() <= kMaxBytes) return name;
    std::size_t begin = name.size() - kMaxBytes;
    while (begin < name.size() && (static_cast<unsigned char>(name[begin]) & 0xC0) == 0x80) ++begin;
    return "\xE2\x80\xA6" + name.substr(begin);  // An ellipsis, in UTF-8.
}

double angle_of(std::size_t index, std::size_t count) {
    return 2.0 * std::numbers::pi * static_cast<double>(index) / static_cast<double>(count) -
           0.5 * std::numbers::pi;
}

std::array<double, 2> place_of(std::size_t index, std::size_t count) {
    const double angle = angle_of(index, count);
    return {0.5 * kSide + kRadius * std::cos(angle), 0.5 * kSide + kRadius * std::sin(angle)};
}

bool is_flat(const PairGeometry& pair) {
    const PairConfiguration kind = pair.pair.configuration;
    return kind == PairConfiguration::kPlanar || kind == PairConfiguration::kPanoramic ||
           kind == PairConfiguration::kPlanarOrPanoramic;
}

void draw_pairs(std::string& svg, const CaptureEvidence& evidence) {
    const std::size_t count = evidence.photographs.size();
    for (const PairGeometry& pair : evidence.pairs) {
        const auto from = place_of(static_cast<std::size_t>(pair.pair.first), count);
        const auto to = place_of(static_cast<std::size_t>(pair.pair.second), count);
        const double inliers = static_cast<double>(pair.pair.inliers.size());
        const double width = std::clamp(0.5 * std::log2(inliers / 10.0), 0.4, 3.5);
        svg += formatted(
            "<path stroke=\"%s\" stroke-width=\"%.1f\" stroke-opacity=\"0.55\" "
            "d=\"M%.1f %.1fL%.1f %.1f\"/>\n",
            is_flat(pair) ? kFlat : kGeneral, width, from[0], from[1], to[0], to[1]);
    }
}

std::vector<const char*> colors_of(const CaptureEvidence& evidence) {
    std::vector<const char*> colors(evidence.photographs.size(), kAlone);
    std::size_t next = 0;
    for (const std::vector<int>& group : groups_of(match_graph_of(evidence))) {
        if (group.size() < 2) continue;
        for (const int index : group) {
            colors[static_cast<std::size_t>(index)] = kGroupColors[next % kGroupColors.size()];
        }
        ++next;
    }
    return colors;
}

void draw_photographs(std::string& svg, const CaptureEvidence& evidence) {
    const std::size_t count = evidence.photographs.size();
    const std::vector<const char*> colors = colors_of(evidence);
    const std::vector<int> bridging = bridging_photographs(match_graph_of(evidence));
    const std::size_t name_every = 1 + (count - 1) / kMaxNames;
    for (std::size_t index = 0; index < count; ++index) {
        const auto [x, y] = place_of(index, count);
        svg += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"5\" fill=\"%s\"/>\n", x, y,
                         colors[index]);
        if (std::binary_search(bridging.begin(), bridging.end(), static_cast<int>(index))) {
            svg += formatted(
                "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"8.5\" fill=\"none\" stroke=\"#c0392b\" "
                "stroke-width=\"2\"/>\n",
                x, y);
        }
        if (index % name_every != 0) continue;
        const double angle_deg = angle_of(index, count) * 180.0 / std::numbers::pi;
        const bool is_left = std::cos(angle_of(index, count)) < -1e-9;
        svg += formatted(
            "<text transform=\"translate(%.1f %.1f) rotate(%.1f)\" x=\"%d\" y=\"3.5\" "
            "text-anchor=\"%s\">",
            x, y, is_left ? angle_deg + 180.0 : angle_deg, is_left ? -13 : 13,
            is_left ? "end" : "start");
        svg += svg_escaped(short_name(evidence.photographs[index].name)) + "</text>\n";
    }
}

}  // namespace

std::string match_graph_svg(const CaptureEvidence& evidence) {
    std::string svg;
    svg += formatted(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" "
        "font-family=\"sans-serif\" font-size=\"11\" fill=\"#333333\">\n"
        "<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n",
        kSide, kSide + kFootline);
    draw_pairs(svg, evidence);
    draw_photographs(svg, evidence);
    svg += formatted("<text x=\"12\" y=\"%.0f\">", kSide + 8);
    svg +=
        "lines: photographs that show the same things (blue: with parallax, orange: one plane or "
        "a turn explains them)</text>\n";
    svg += formatted("<text x=\"12\" y=\"%.0f\">", kSide + 26);
    svg +=
        "dots: photographs, a colour a group, grey without any; red rings: the group would fall "
        "apart without them</text>\n</svg>\n";
    return svg;
}

}  // namespace lumi
