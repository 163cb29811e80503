#include <array>
#include <string>

#include "pipeline/synth/hand_held_path.h"
#include "pipeline/synth/read_vectors.h"

namespace lumi {
namespace {

struct PathEntry {
    PathKind kind;
    std::string_view name;
};

constexpr std::array<PathEntry, 7> kPaths{{
    {PathKind::kArc, "arc"},
    {PathKind::kRing, "ring"},
    {PathKind::kHemisphere, "hemisphere"},
    {PathKind::kGrid, "grid"},
    {PathKind::kLine, "line"},
    {PathKind::kForward, "forward"},
    {PathKind::kRotation, "rotation"},
}};

double read_elevation(const ConfigSection& section, const std::string& key, double fallback) {
    const double elevation_deg = section.number(key, fallback);
    if (!(elevation_deg > -90 && elevation_deg < 90)) {
        section.refuse(key, "degrees between -90 and 90");
    }
    return elevation_deg;
}

}  // namespace

std::string_view name_of(PathKind kind) {
    for (const PathEntry& entry : kPaths) {
        if (entry.kind == kind) return entry.name;
    }
    return {};
}

std::optional<PathKind> path_kind_named(std::string_view name) {
    for (const PathEntry& entry : kPaths) {
        if (entry.name == name) return entry.kind;
    }
    return std::nullopt;
}

HandHeldPath read_hand_held_path(const ConfigSection& section) {
    HandHeldPath path;
    const auto kind = path_kind_named(section.text("kind", std::string(name_of(path.kind))));
    if (!kind) section.refuse("kind", "arc, ring, hemisphere, grid, line, forward or rotation");
    path.kind = *kind;
    path.count = section.integer("count", path.count);
    if (path.count < 1 || path.count > 10'000) section.refuse("count", "1 to 10000");
    path.rows = section.integer("rows", path.rows);
    if (path.rows < 1 || path.rows > path.count) section.refuse("rows", "1 to `count`");
    path.start_at = section.integer("start_at", path.start_at);
    if (path.start_at < 0 || path.start_at >= path.count) {
        section.refuse("start_at", "0 to `count` - 1");
    }
    path.target_in_world = read_vector(section, "target", path.target_in_world);
    path.distance = read_positive(section, "distance", path.distance);
    path.azimuth_deg = section.number("azimuth_deg", path.azimuth_deg);
    path.span_deg = read_not_negative(section, "span_deg", path.span_deg);
    path.elevation_deg = read_elevation(section, "elevation_deg", path.elevation_deg);
    path.top_elevation_deg = read_elevation(section, "top_elevation_deg", path.elevation_deg);
    path.length_share = read_not_negative(section, "length_share", path.length_share);
    if (path.kind == PathKind::kForward && path.length_share >= 1) {
        section.refuse("length_share", "less than 1: the path ends before the target");
    }
    path.position_jitter_share =
        read_not_negative(section, "position_jitter_share", path.position_jitter_share);
    path.aim_jitter_deg = read_not_negative(section, "aim_jitter_deg", path.aim_jitter_deg);
    path.roll_jitter_deg = read_not_negative(section, "roll_jitter_deg", path.roll_jitter_deg);
    return path;
}

}  // namespace lumi
