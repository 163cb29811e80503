#include "render/subdivision/triangle_budget.h"

#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

/// What a frame still counts when the next was drawn.
constexpr double kMemory = 0.8;
/// Numbers of triangles that differ by less, as a share of their mean, tell nothing of what one
/// costs: it is what it was before, and half of the frame's time at first.
constexpr double kLeastSpread = 0.03;
/// Within this of what is affordable nothing is changed: triangles that come and go are seen.
constexpr double kDeadBand = 0.1;
/// Powers of the excess of triangles. Their number may fall steeply with the error, so that quick
/// steps both ways would go to and fro.
constexpr double kStepUp = 0.5;
constexpr double kStepDown = 0.1;
/// Of what the frame takes without them: triangles that take no more are not given away.
constexpr double kLeastShare = 0.1;
/// More triangles than are affordable by this are not drawn even while the errors are learned.
constexpr double kMostExcess = 1.2;

}  // namespace

TriangleBudget::TriangleBudget(double frames_per_second)
    : target_ms_(frames_per_second > 0 ? 1000 / frames_per_second : 0.0) {}

void TriangleBudget::measured(std::size_t triangles, double frame_ms) {
    if (target_ms_ <= 0 || triangles == 0) return;
    const auto count = static_cast<double>(triangles);
    for (double* sum : {&frames_, &triangles_, &ms_, &triangles_squared_, &triangles_ms_})
        *sum *= kMemory;
    frames_ += 1;
    triangles_ += count;
    ms_ += frame_ms;
    triangles_squared_ += count * count;
    triangles_ms_ += count * frame_ms;
    learn_cost();
    const double excess = count / affordable_;
    if (std::abs(excess - 1) <= kDeadBand) return;
    const double step = std::pow(excess, excess > 1 ? kStepUp : kStepDown);
    relaxation_ = std::clamp(relaxation_ * step, 1.0, kMostRelaxation);
}

void TriangleBudget::learn_cost() {
    const double mean = triangles_ / frames_;
    const double mean_ms = ms_ / frames_;
    const double spread = triangles_squared_ / frames_ - mean * mean;
    const double together = triangles_ms_ / frames_ - mean * mean_ms;
    // Triangles take some of the time, and no more than all of it.
    const auto possible = [&](double ms_each) {
        return std::clamp(ms_each, 0.05 * mean_ms / mean, mean_ms / mean);
    };
    if (spread > kLeastSpread * kLeastSpread * mean * mean) ms_each_ = possible(together / spread);
    const double ms_each = possible(ms_each_ > 0 ? ms_each_ : 0.5 * mean_ms / mean);
    const double ms_without = mean_ms - mean * ms_each;
    // What cannot be afforded at all is approached by halves.
    affordable_ = std::max(
        {(target_ms_ - ms_without) / ms_each, 0.5 * mean, kLeastShare * ms_without / ms_each});
}

RenderOptions TriangleBudget::within(RenderOptions options) const {
    options.triangle_error_ratio *= relaxation_;
    if (affordable_ <= 0) return options;
    const auto most = static_cast<std::size_t>(std::ceil(kMostExcess * affordable_));
    if (options.max_triangles == 0 || most < options.max_triangles) options.max_triangles = most;
    return options;
}

}  // namespace lumi
