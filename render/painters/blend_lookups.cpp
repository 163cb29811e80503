#include "render/painters/blend_lookups.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace lumi {
namespace {

constexpr std::size_t kViews = 3;
constexpr std::uint32_t kNone = 0xffffffffU;

/// For each of the three photographs of a triangle the one that it is looked up with: itself, an
/// earlier one that is the same, or none when it has no weight.
using Lookups = std::array<std::uint8_t, kViews>;
constexpr std::uint8_t kNotLookedUp = kViews;
/// Lookups as a number: each is one of four.
constexpr std::size_t kWays = 64;

std::size_t number_of(const Lookups& lookups) {
    return static_cast<std::size_t>(lookups[0] + 4 * lookups[1] + 16 * lookups[2]);
}

/// Whether photograph k is looked up where an earlier one is, so that weights add up.
bool is_same(const BlendVertex& vertex, std::size_t k, std::size_t earlier) {
    return vertex.view_layers[k] == vertex.view_layers[earlier] &&
           vertex.view_pixels[k] == vertex.view_pixels[earlier];
}

Lookups lookups_on(const std::array<const BlendVertex*, 3>& corners) {
    const auto all = [&](const auto& holds) {
        return std::all_of(corners.begin(), corners.end(),
                           [&](const BlendVertex* corner) { return holds(*corner); });
    };
    Lookups lookups{kNotLookedUp, kNotLookedUp, kNotLookedUp};
    for (std::size_t k = 0; k < kViews; ++k) {
        if (all([&](const BlendVertex& corner) { return corner.weights[k] == 0.0F; })) continue;
        lookups[k] = static_cast<std::uint8_t>(k);
        for (std::size_t earlier = 0; earlier < k; ++earlier)
            if (lookups[earlier] == earlier &&
                all([&](const BlendVertex& corner) { return is_same(corner, k, earlier); }))
                lookups[k] = static_cast<std::uint8_t>(earlier);
    }
    // What no photograph has a weight on is black, and still a triangle.
    if (lookups == Lookups{kNotLookedUp, kNotLookedUp, kNotLookedUp}) lookups[0] = 0;
    return lookups;
}

std::size_t count_of(const Lookups& lookups) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < kViews; ++k)
        if (lookups[k] == k) ++count;
    return count;
}

/// The vertex with the photographs that are looked up first.
BlendVertex arranged(const BlendVertex& vertex, const Lookups& lookups) {
    BlendVertex result = vertex;
    result.weights = {};
    std::array<std::size_t, kViews> place{};
    std::size_t next = 0;
    for (std::size_t k = 0; k < kViews; ++k) {
        if (lookups[k] == kNotLookedUp) continue;
        if (lookups[k] == k) {
            place[k] = next++;
            result.view_pixels[place[k]] = vertex.view_pixels[k];
            result.view_layers[place[k]] = vertex.view_layers[k];
            result.depth_ratios[place[k]] = vertex.depth_ratios[k];
        }
        result.weights[place[lookups[k]]] += vertex.weights[k];
    }
    return result;
}

}  // namespace

TrianglesByLookups sorted_by_lookups(const BlendTriangles& triangles,
                                     const std::vector<LumigraphView>& views, double border_px) {
    TrianglesByLookups sorted;
    std::array<std::array<std::vector<std::uint32_t>, 2>, kViews> indices;
    std::array<std::vector<std::uint32_t>, kWays> places;  // Of vertices, where there are any.
    sorted.triangles.vertices.reserve(triangles.vertices.size());
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        const std::uint32_t* corner = &triangles.indices[i];
        const std::array<const BlendVertex*, 3> corners{&triangles.vertices[corner[0]],
                                                        &triangles.vertices[corner[1]],
                                                        &triangles.vertices[corner[2]]};
        const Lookups lookups = lookups_on(corners);
        std::vector<std::uint32_t>& among =
            indices[count_of(lookups) - 1][may_show_none(corners, views, border_px) ? 1 : 0];
        std::vector<std::uint32_t>& place = places[number_of(lookups)];
        if (place.empty()) place.assign(triangles.vertices.size(), kNone);
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t& at = place[corner[k]];
            if (at == kNone) {
                at = static_cast<std::uint32_t>(sorted.triangles.vertices.size());
                sorted.triangles.vertices.push_back(
                    arranged(triangles.vertices[corner[k]], lookups));
            }
            among.push_back(at);
        }
    }
    for (std::size_t lookups = 1; lookups <= kViews; ++lookups) {
        for (const bool none : {false, true}) {
            const std::vector<std::uint32_t>& run = indices[lookups - 1][none ? 1 : 0];
            if (run.empty()) continue;
            sorted.runs.push_back({lookups, none, run.size()});
            sorted.triangles.indices.insert(sorted.triangles.indices.end(), run.begin(), run.end());
        }
    }
    return sorted;
}

}  // namespace lumi
