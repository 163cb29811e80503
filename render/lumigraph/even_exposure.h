#pragma once

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// A view's photograph in the exposure of those around it.
///
/// Light is multiplied, and encoded and rounded again. Above 9/10 of the encoded range values go
/// over to white, which stays white: how bright saturated pixels were nobody knows, and borders
/// between white and nearly white would show otherwise.
[[nodiscard]] ColorImage evened_photograph(const LumigraphView& view);

/// The same of all views; exposure gains are 1 then.
void even_exposures(Lumigraph& lumigraph);

}  // namespace lumi
