#pragma once

#include <string>
#include <vector>

#include "render/rivals/resampled_lumigraph.h"

namespace lumi {

/// Why a rival cannot be drawn from a Lumigraph, in words; empty where it can.
using ReasonAgainst = std::string (*)(const Lumigraph& lumigraph);

/// A rival that draws in plain code from the photographs and their depth.
struct PlainRival {
    std::string name;
    ReasonAgainst reason_against;
    Frame (*draw)(const Lumigraph& lumigraph, const Eye& eye);
};

/// A rival that draws from pictures in an arrangement of its own: the photographs are resampled
/// (resampled_lumigraph.h), and what comes of it is a Lumigraph that all modes draw.
struct ResampledRival {
    std::string name;
    ReasonAgainst reason_against;
    LightFieldLayout (*layout)(const Lumigraph& source);
};

/// Unstructured lumigraph, view-dependent texture, forward warping.
[[nodiscard]] const std::vector<PlainRival>& plain_rivals();

/// Two-plane, with about as many pictures as there are photographs: one slab where one plane can
/// stand between all cameras and the scene, else six. Spherical, where none can. Pictures are
/// square and have about as many pixels as a photograph.
[[nodiscard]] const std::vector<ResampledRival>& resampled_rivals();

}  // namespace lumi
