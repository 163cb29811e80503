#pragma once

#include <vector>

#include "pipeline/chart/chart_result.h"
#include "pipeline/target/wish.h"

namespace lumi {

/// What a point of a chart measures.
[[nodiscard]] Achievement achievement_of(const ChartPoint& point);

/// The points in the order in which they should be tried for a wish. First those that meet it: for
/// an accuracy the one that is built fastest first, for a budget (speed, size, time) the most
/// accurate one first. Then the others, the nearest to the wish first.
[[nodiscard]] std::vector<ChartPoint> candidates_for(const Wish& wish,
                                                     std::vector<ChartPoint> points);

}  // namespace lumi
