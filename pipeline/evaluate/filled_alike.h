#pragma once

#include <map>
#include <string>

#include "calib/capture/posed_photographs.h"
#include "pipeline/evaluate/common_pixels.h"
#include "pipeline/evaluate/evaluation.h"
#include "pipeline/evaluate/judged_view.h"

namespace lumi {

/// Judged views of all modes and methods on the same pixels (common_pixels.h), whose frames have
/// the same surroundings (surroundings.h) where they cover nothing.
class FilledAlike {
 public:
    FilledAlike(const Lumigraph& lumigraph, const PosedPhotographs& held_out);

    /// A view that the method drew, one of those held out.
    void add(const ComparedMethod& method, const JudgedView& view);
    /// Of the modes and rivals of the evaluation, which were all added.
    [[nodiscard]] CommonPixelScores scores_of(const Evaluation& evaluation) const;

 private:
    std::map<std::string, ColorImage> surroundings_;  ///< By the view's name.
    CommonPixels common_;
};

}  // namespace lumi
