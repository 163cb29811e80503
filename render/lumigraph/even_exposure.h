#pragma once

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The photographs as they would be in the capture's common exposure; exposure gains are 1 then.
///
/// Light is multiplied, and encoded and rounded again. Above 9/10 of the encoded range values go
/// over to white, which stays white: how bright saturated pixels were nobody knows, and borders
/// between white and nearly white would show otherwise.
void even_exposures(Lumigraph& lumigraph);

}  // namespace lumi
