#pragma once

#include <vector>

#include "pipeline/chart/chart_result.h"
#include "pipeline/target/wish.h"

namespace lumi {

/// What a point of a chart measures.
[[nodiscard]] Achievement achievement_of(const ChartPoint& point);

/// The points in the order in which they should be tried for a wish. First those that meet it: for
/// an accuracy the one that is built fastest first, for a budget (speed, size, time) the most
/// accurate one first. Then the others, the nearest to the wish first. A method that leaves more
/// than a tenth of what another shows empty is fast for that alone, and comes last.
[[nodiscard]] std::vector<ChartPoint> candidates_for(const Wish& wish,
                                                     std::vector<ChartPoint> points);

/// Brings the variants of a sweep into the order of what they are expected to cost, the cheapest
/// first: pixels times what the depth model takes for each.
void put_cheapest_first(Sweep& sweep);

/// Whether the sweep, cheapest first, may end with a variant. An accuracy is reached by the first
/// that reaches it. A budget asks for the most accurate of all that keep within it; those after one
/// that took half as long again as there is time are left out.
[[nodiscard]] bool ends_the_sweep(const Wish& wish, const MeasuredVariant& variant);

}  // namespace lumi
