#pragma once

#include <optional>

#include "calib/capture/capture.h"
#include "calib/poses/mapping_job.h"
#include "calib/poses/refinement.h"
#include "calib/poses/second_model.h"

namespace lumi {

/// Whether the focus zoomed: a lens that moves to focus changes its focal length by a per cent or
/// two from photograph to photograph (focus breathing), while everything else of it stays.
///
/// Asked where residuals (of `refined`) look like it (ResidualPattern::is_zoomed). `mapped` is the
/// model before the refinement, with the observations that it dropped. Own scales have to explain
/// it better than one lens (own_scales_explain_better), and a lens that moved better than a camera
/// that turned (adjust_supposing). Then
/// each view is given the shared lens with a focal length of its own; pictures are then scaled
/// about their principal points as if all had been taken with the mean focal length: distortion is
/// a matter of directions, so that nothing else of them changes. Of those, lenses are chosen as
/// ever (refine with `policy`; where that moves the principal point, the pictures were scaled about
/// a place off by as much, which their poses make up for), and focal lengths adjusted once more.
/// Returns that model, of which `job.evidence` then tells, with a camera for each view; empty where
/// nothing tells of a zoom, or where it would place fewer views or come to none. Throws Error:
/// E-INTERRUPTED.
[[nodiscard]] std::optional<SecondModel> find_own_focal_lengths(const MappingJob& job,
                                                                LensPolicy policy,
                                                                const Capture& mapped,
                                                                const Capture& refined);

}  // namespace lumi
