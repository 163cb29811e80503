#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/synth/ray.h"

namespace lumi {

/// Two places on a ray, outside and inside of a surface, and its signed distances there.
struct SurfaceCrossing {
    double outside = 0.0;
    double distance_outside = 0.0;
    double inside = 0.0;
    double distance_inside = 0.0;
};

/// Closes in on the surface by the Illinois variant of regula falsi, to `tolerance`.
template <class DistanceAt>
[[nodiscard]] double place_of_crossing(SurfaceCrossing crossing, double tolerance,
                                       const DistanceAt& distance_at) {
    bool was_outside = false;
    bool was_inside = false;
    double place = crossing.outside;
    for (int iteration = 0; iteration < 60; ++iteration) {
        place = (crossing.outside * crossing.distance_inside -
                 crossing.inside * crossing.distance_outside) /
                (crossing.distance_inside - crossing.distance_outside);
        const double distance = distance_at(place);
        if (std::abs(distance) < tolerance) break;
        if (crossing.inside - crossing.outside < tolerance) break;
        const bool is_outside = distance > 0.0;
        if (is_outside) {
            crossing.outside = place;
            crossing.distance_outside = distance;
            if (was_outside) crossing.distance_inside *= 0.5;
        } else {
            crossing.inside = place;
            crossing.distance_inside = distance;
            if (was_inside) crossing.distance_outside *= 0.5;
        }
        was_outside = is_outside;
        was_inside = !is_outside;
    }
    return place;
}

/// The first place within `span` where `distance_at(place)`, the signed distance to a surface of
/// the given size, comes down to zero. Empty when there is none, or when the span starts inside.
///
/// Sphere tracing (Hart 1996), stretched near the surface, where the distance is nearly linear
/// along the ray.
template <class DistanceAt>
[[nodiscard]] std::optional<double> sphere_trace(RaySpan span, double size,
                                                 const DistanceAt& distance_at) {
    // Distances may be exact to first order only: shorter steps keep the march outside.
    constexpr double kSafeStep = 0.9;
    constexpr double kMaxStretch = 4.0;
    constexpr int kMaxSteps = 512;
    const double close = 1e-2 * size;
    const double on_surface = 1e-10 * size;

    double previous = span.near;
    double previous_distance = distance_at(previous);
    if (std::abs(previous_distance) < on_surface) return previous;
    if (previous_distance < 0.0) return std::nullopt;
    double place = previous + kSafeStep * previous_distance;
    for (int step = 0; step < kMaxSteps && place <= span.far; ++step) {
        const double distance = distance_at(place);
        if (distance < 0.0) {
            return place_of_crossing({previous, previous_distance, place, distance},
                                     0.1 * on_surface, distance_at);
        }
        if (distance < on_surface) return place;
        double advance = kSafeStep * distance;
        if (distance < close && distance < previous_distance) {
            const double to_root = distance * (place - previous) / (previous_distance - distance);
            advance = std::clamp(1.001 * to_root, advance, kMaxStretch * distance);
        }
        previous = place;
        previous_distance = distance;
        place += advance;
    }
    return std::nullopt;
}

}  // namespace lumi
