#pragma once

#include <vector>

#include "pipeline/evaluate/kept_back_photographs.h"
#include "render/lumigraph/drawing_choices.h"

namespace lumi {

/// What photographs lose, in the mean, where blocks are so wide in their pixels.
struct BlockLoss {
    double width_px = 1.0;
    double loses_db = 0.0;
};

/// The width at which `most_db` is lost. `by_width` goes from narrow to wide; between two widths
/// the loss changes linearly, blocks of one pixel lose nothing, and the widest is the most there
/// is.
[[nodiscard]] double width_that_loses(double most_db, const std::vector<BlockLoss>& by_width);

/// How wide blocks of two by two pixels may be (DrawingChoices::depth_block_px) where the widest
/// lose `widest_lose_db`, more than `most_db`: photographs that are kept back are drawn in finer
/// frames, in blocks and pixel by pixel, which are then reduced to their size. The more pixels a
/// frame has for each of a photograph's, the less anyone sees of its blocks. Large photographs are
/// asked in a smaller size, so that their blocks might be wider still. The narrowest for fewer than
/// eight views, of which nobody is asked. Throws Error (E-GL-...).
[[nodiscard]] double sufficient_block_px(KeptBackPhotographs& photographs, DrawingChoices drawing,
                                         double widest_lose_db, double most_db);

}  // namespace lumi
