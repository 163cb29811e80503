#pragma once

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// A view's photograph in the exposure of those around it, and without its lens's falloff
/// (light_left.h): its corners become as bright as the same surfaces are in the middle of a
/// picture.
///
/// Light is multiplied, and encoded and rounded again. What lies above 9/10 of the encoded range
/// where it is brighter goes over to white, which stays white: how bright saturated pixels were
/// nobody knows, borders between white and nearly white would show otherwise, and nothing is lost
/// that is brightened.
[[nodiscard]] ColorImage evened_photograph(const LumigraphView& view, double light_falloff);

/// The same of all views; exposure gains are 1 then, and the falloff is Lumigraph::evened_falloff.
void even_exposures(Lumigraph& lumigraph);

/// A picture as a lens of such a falloff would have taken it: to be compared with what it took.
[[nodiscard]] ColorImage darkened_by_lens(ColorImage picture, const Camera& camera, double falloff);
/// The inverse, of a photograph: to be compared with a picture.
[[nodiscard]] ColorImage without_falloff(ColorImage photograph, const Camera& camera,
                                         double falloff);

}  // namespace lumi
