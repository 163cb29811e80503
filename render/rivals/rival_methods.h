#pragma once

#include <string>
#include <vector>

#include "render/reference/eye_depths.h"
#include "render/rivals/resampled_lumigraph.h"

namespace lumi {

/// Why a rival cannot be drawn from a Lumigraph, in words; empty where it can.
using ReasonAgainst = std::string (*)(const Lumigraph& lumigraph);

/// A rival that draws in plain code from the photographs, and from their depth or without.
struct PlainRival {
    std::string name;
    ReasonAgainst reason_against;
    bool draws_from_depth;
    /// Whether it draws on geometry that its paper is given: what all depth comes to at the eye.
    bool draws_on_eye_depths;
    /// `known` is that of depths_for.
    Frame (*draw)(const Lumigraph& lumigraph, const Eye& eye, const EyeDepths& known);
};

/// A rival that draws from pictures in an arrangement of its own: the photographs are resampled
/// (resampled_lumigraph.h), and what comes of it is a Lumigraph that all modes draw.
struct ResampledRival {
    std::string name;
    ReasonAgainst reason_against;
    LightFieldLayout (*layout)(const Lumigraph& source);
};

/// Unstructured lumigraph, view-dependent texture, forward warping; without depth, dynamically
/// reparameterized light fields.
[[nodiscard]] const std::vector<PlainRival>& plain_rivals();

/// The geometry that such a rival draws on (eye_depths.h), whose finding is no part of its paper;
/// empty for one that draws on none.
[[nodiscard]] EyeDepths depths_for(const PlainRival& rival, const Lumigraph& lumigraph,
                                   const Eye& eye);

/// Two-plane, with about as many pictures as there are photographs: one slab where all cameras look
/// within 60 degrees of their mean axis; else six. Spherical where they
/// do not, with the number of directions that is nearest to the number of photographs. Pictures
/// have as many pixels as the median photograph and show as much; those of a slab have its shape,
/// others are square.
[[nodiscard]] const std::vector<ResampledRival>& resampled_rivals();

}  // namespace lumi
