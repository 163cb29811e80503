#include "render/depth_search/relaxation_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumi {
namespace {

constexpr int kStepsPerOctave = 4;
constexpr int kMostSteps = 10 * kStepsPerOctave;
/// The first step up; each one after it is twice as long.
constexpr int kFirstStepsUp = kStepsPerOctave / 2;
/// The longest step down, and where nothing tells how the number of triangles grows.
constexpr int kBlindSteps = kStepsPerOctave;
/// From this share of the triangles that may be drawn on, half as many: beyond the number, what was
/// looked up for too many triangles is lost.
constexpr double kMany = 0.25;
constexpr int kBlindStepsFromMany = kBlindSteps / 2;
/// This share of the triangles that may be drawn is enough: another round would cost more than it
/// betters the picture.
constexpr double kEnough = 0.8;
/// Numbers often grow faster than before, and to find that they are too many costs more than
/// another round.
constexpr double kCaution = 0.8;

double relaxation_of(int steps) { return std::exp2(static_cast<double>(steps) / kStepsPerOctave); }

/// Steps that were found to keep to the number, and how many triangles they make.
struct Kept {
    int steps = kMostSteps + 1;
    double triangles = 0.0;
};

/// How many steps less make as many triangles as may be, by the growth from one to the other.
int steps_to_go(const Kept& coarser, const Kept& finer, double most) {
    const int most_steps = finer.triangles < kMany * most ? kBlindSteps : kBlindStepsFromMany;
    if (coarser.steps > kMostSteps) return most_steps;
    const double growth =
        std::log(finer.triangles / coarser.triangles) / (coarser.steps - finer.steps);
    const double to_go = std::log(most / finer.triangles) / std::max(growth, 0.02);
    return std::clamp(static_cast<int>(kCaution * to_go), 1, most_steps);
}

}  // namespace

double least_relaxation(std::size_t most, const TrianglesAt& triangles_at) {
    constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();
    if (most == 0) {
        static_cast<void>(triangles_at(1.0, kAnyNumber));
        return 1.0;
    }
    Kept coarser;
    Kept finest;
    int too_fine = -1;  // Steps that make too many triangles.
    int steps = 0;
    int steps_up = kFirstStepsUp;
    while (true) {
        const auto triangles = triangles_at(relaxation_of(steps), most);
        if (triangles) {
            coarser = finest;
            finest = {steps, static_cast<double>(std::max<std::size_t>(1, *triangles))};
            if (finest.triangles >= kEnough * static_cast<double>(most)) break;
        } else {
            too_fine = steps;
        }
        if (finest.steps - too_fine <= 1) break;
        if (triangles) {
            const int to_go = steps_to_go(coarser, finest, static_cast<double>(most));
            steps = std::max(finest.steps - to_go, too_fine + 1);
        } else if (finest.steps <= kMostSteps) {
            steps = (finest.steps + too_fine) / 2;
        } else {
            steps = std::min(too_fine + steps_up, kMostSteps);
            steps_up *= 2;
        }
    }
    if (finest.steps > kMostSteps) {
        static_cast<void>(triangles_at(relaxation_of(kMostSteps), kAnyNumber));
        return relaxation_of(kMostSteps);
    }
    return relaxation_of(finest.steps);
}

}  // namespace lumi
