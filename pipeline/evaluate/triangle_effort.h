#pragma once

#include "pipeline/evaluate/kept_back_photographs.h"
#include "pipeline/stages/drawing_effort.h"
#include "render/lumigraph/drawing_choices.h"

namespace lumi {

/// How far the triangles of `adaptive` may err before photographs that are kept back can tell
/// (kept_back_photographs.h): the largest error asked that loses nothing that anyone sees beside
/// the best; and whether what is thinner is to be drawn over them: where that gains more than one
/// standard error, and enough to be seen, with triangles of the given error, the usual one if it is
/// 0. All else is drawn as `drawing` says. For fewer than eight views nobody is asked. Throws Error
/// (E-GL-...).
[[nodiscard]] TriangleEffort sufficient_triangle_effort(KeptBackPhotographs& photographs,
                                                        DrawingChoices drawing,
                                                        double given_error_px = 0);

}  // namespace lumi
