#pragma once

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The photographs, each in the exposure of those around it; exposure gains are 1 then.
///
/// Light is multiplied, and encoded and rounded again. Above 9/10 of the encoded range values go
/// over to white, which stays white: how bright saturated pixels were nobody knows, and borders
/// between white and nearly white would show otherwise.
void even_exposures(Lumigraph& lumigraph);

}  // namespace lumi
