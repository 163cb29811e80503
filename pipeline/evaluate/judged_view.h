#pragma once

#include <functional>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "pipeline/evaluate/timed_frame.h"
#include "pipeline/evaluate/view_score.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// A photograph, what the Lumigraph shows from its place, and how they compare.
struct JudgedView {
    ViewScore score;
    ColorImage photograph;
    GrayImage subject;  ///< Of the photograph; empty where it is not known.
    Frame rendering;
    FloatImage flip;          ///< Error map.
    FloatImage ghost_energy;  ///< Empty when it was not asked for.
};

/// Which pixels of a held-out photograph are of the subject (255) and which are not (0), by the
/// view's name; an empty picture where that is not known.
using SubjectMask =
    std::function<GrayImage(const std::string& view_name, const ColorImage& photograph)>;

/// The eyes that took held-out photographs.
[[nodiscard]] std::vector<Eye> eyes_of(const PosedPhotographs& held_out);

/// Judges what was drawn of the Lumigraph in the place of one of the held-out photographs, and took
/// these times; as dark towards its corners as the photograph, if the Lumigraph's were evened out.
/// `subject_mask` may be empty. Throws Error for a photograph that cannot be read.
[[nodiscard]] JudgedView judged_view(const PosedPhotographs& held_out, std::size_t index,
                                     const Lumigraph& lumigraph, const SubjectMask& subject_mask,
                                     Frame rendering, const RepeatedTimes& times);

}  // namespace lumi
