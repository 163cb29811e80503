#include "calib/poses/walk_in_rounds.h"

#include <algorithm>
#include <cstddef>
#include <map>

#include "calib/ingest/photograph_order.h"
#include "calib/work/formatted.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

/// Null where a photograph was not placed.
using Walk = std::vector<const View*>;

Walk walk_of(const Capture& model, const std::vector<Photograph>& photographs) {
    std::map<std::string, const View*> view_of_name;
    for (const View& view : model.views) view_of_name.emplace(view.name, &view);
    const std::vector<int> places = places_in_order(photographs);
    Walk walk(photographs.size(), nullptr);
    for (std::size_t index = 0; index < photographs.size(); ++index) {
        const auto view = view_of_name.find(photographs[index].name);
        if (view != view_of_name.end())
            walk[static_cast<std::size_t>(places[index])] = view->second;
    }
    return walk;
}

double distance_between(const View& first, const View& second) {
    return (centre_in_world(second.cam_from_world) - centre_in_world(first.cam_from_world)).norm();
}

/// From every `every`-th photograph, counted from `first`, to the next one.
std::vector<double> steps_of(const Walk& walk, std::size_t first = 0, std::size_t every = 1) {
    std::vector<double> steps;
    for (std::size_t index = first; index + 1 < walk.size(); index += every) {
        if (walk[index] != nullptr && walk[index + 1] != nullptr)
            steps.push_back(distance_between(*walk[index], *walk[index + 1]));
    }
    return steps;
}

/// How far later rounds are from the first one.
struct Return {
    std::vector<double> missed;
    double largest_turn_rad = 0;
};

Return return_after(std::size_t places, const Walk& walk) {
    Return back;
    for (std::size_t index = places; index < walk.size(); ++index) {
        const View* const at_first = walk[index % places];
        const View* const again = walk[index];
        if (at_first == nullptr || again == nullptr) continue;
        back.missed.push_back(distance_between(*at_first, *again));
        const double turn_rad =
            at_first->cam_from_world.rotation.angularDistance(again->cam_from_world.rotation);
        back.largest_turn_rad = std::max(back.largest_turn_rad, turn_rad);
    }
    return back;
}

/// The largest of the nine tenths that are smallest; there is at least one.
double ninth_tenth(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[(values.size() - 1) * 9 / 10];
}

/// Whether every round ends with a leap back to its first place. Two places have no such end.
bool leaps_back(const Walk& walk, std::size_t places, double step) {
    constexpr double kLeap = 1.8;
    if (places == 2) return true;
    for (std::size_t last = 0; last < places; ++last) {
        const std::vector<double> ends = steps_of(walk, last, places);
        if (!ends.empty() && *std::min_element(ends.begin(), ends.end()) > kLeap * step)
            return true;
    }
    return false;
}

}  // namespace

std::string WalkInRounds::text() const {
    return formatted(
        "the photographs would have been taken in %d rounds of the same %d places, each met again "
        "to within %.0f %% of a step: sides that look alike were probably taken for one another "
        "(if the camera did return to its places, keep the photographs of one round)",
        rounds, places, 100 * missed_share);
}

std::optional<WalkInRounds> walk_in_rounds(const Capture& model,
                                           const std::vector<Photograph>& photographs) {
    // A hand that photographs a place anew misses it by more.
    constexpr double kSamePlace = 0.25;
    constexpr double kSameView_rad = 0.2;
    const Walk walk = walk_of(model, photographs);
    const std::vector<double> steps = steps_of(walk);
    if (steps.empty()) return std::nullopt;
    const double step = median_of(steps);
    for (std::size_t places = 2; 2 * places <= walk.size(); ++places) {
        const Return back = return_after(places, walk);
        if (back.missed.size() < places || back.largest_turn_rad > kSameView_rad) continue;
        const double missed_share = ninth_tenth(back.missed) / step;
        if (missed_share > kSamePlace || !leaps_back(walk, places, step)) continue;
        return WalkInRounds{static_cast<int>(places),
                            static_cast<int>((walk.size() + places - 1) / places), missed_share};
    }
    return std::nullopt;
}

}  // namespace lumi
