#include "calib/poses/walk_in_rounds.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calib/ingest/photograph_order.h"
#include "calib/work/formatted.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

/// A photograph of a walk.
struct Stop {
    const View* view = nullptr;  ///< Null where it was not placed.
    std::string series;          ///< Equal where names count on, and one camera took them.
};

using Walk = std::vector<Stop>;

/// The name without what counts on: the numbers of the file, which may tell a time, and its ending.
/// Folders keep theirs: they are of two cameras more often than of one walk.
std::string series_of(const Photograph& photograph) {
    const std::size_t file = photograph.name.find_last_of('/') + 1;  // 0 where there is none.
    std::string stem = photograph.name.substr(file, photograph.name.find_last_of('.') - file);
    std::erase_if(stem, [](char letter) { return letter >= '0' && letter <= '9'; });
    return photograph.name.substr(0, file) + stem + '\n' + photograph.camera_key;
}

Walk walk_of(const Capture& model, const std::vector<Photograph>& photographs) {
    std::map<std::string, const View*> view_of_name;
    for (const View& view : model.views) view_of_name.emplace(view.name, &view);
    const std::vector<int> places = places_in_order(photographs);
    Walk walk(photographs.size());
    for (std::size_t index = 0; index < photographs.size(); ++index) {
        const auto view = view_of_name.find(photographs[index].name);
        walk[static_cast<std::size_t>(places[index])] = {
            view != view_of_name.end() ? view->second : nullptr, series_of(photographs[index])};
    }
    return walk;
}

Eigen::Vector3d offset_in_world(const View& from, const View& to) {
    return centre_in_world(to.cam_from_world) - centre_in_world(from.cam_from_world);
}

/// A photograph, and the one that the round before took at its place.
struct Meeting {
    const View* before = nullptr;
    const View* again = nullptr;
    std::size_t round = 0;  ///< Of `again`; 0 is the first.
    std::size_t apart = 0;  ///< Stops from one to the other.
};

struct Rounds {
    std::vector<Meeting> meetings;
    std::vector<std::size_t> place_of;  ///< Of each stop, numbered as in the first round.
};

/// The nearest to a stop of what the round before is expected to have there and of its two
/// neighbours: either round may lack a photograph of the other.
std::size_t nearest_of_three(const Walk& walk, std::size_t again, std::size_t expected) {
    std::size_t nearest = expected;
    for (std::size_t before = expected > 0 ? expected - 1 : 0; before <= expected + 1; ++before) {
        if (before + 1 >= again || walk[before].view == nullptr) continue;
        if (offset_in_world(*walk[before].view, *walk[again].view).norm() <
            offset_in_world(*walk[nearest].view, *walk[again].view).norm()) {
            nearest = before;
        }
    }
    return nearest;
}

/// The walk as rounds of so many places, whether it is one or not.
Rounds rounds_of(std::size_t places, const Walk& walk) {
    Rounds rounds;
    for (std::size_t place = 0; place < places; ++place) rounds.place_of.push_back(place);
    std::size_t before = 0;
    for (std::size_t again = places; again < walk.size(); ++again, ++before) {
        if (walk[before].view != nullptr && walk[again].view != nullptr) {
            before = nearest_of_three(walk, again, before);
            if (walk[before].series == walk[again].series)
                rounds.meetings.push_back(
                    {walk[before].view, walk[again].view, again / places, again - before});
        }
        rounds.place_of.push_back(rounds.place_of[before]);
    }
    return rounds;
}

/// The largest of the nine tenths that are smallest, of fewer than ten all; there is at least one.
double largest_of_nine_tenths(const std::vector<double>& values) {
    return value_of_rank(values, (9 * values.size() + 9) / 10 - 1);
}

/// Without those that are none: where a photograph is missing, the nearest of the round before lies
/// a whole step away.
std::vector<Meeting> without_missing(std::vector<Meeting> meetings, double step) {
    constexpr double kMissing = 0.6;
    std::erase_if(meetings, [&](const Meeting& meeting) {
        return offset_in_world(*meeting.before, *meeting.again).norm() > kMissing * step;
    });
    return meetings;
}

/// How far from its place nine in ten are met again.
double missed_of(const std::vector<Meeting>& meetings) {
    std::vector<double> missed;
    for (const Meeting& meeting : meetings)
        missed.push_back(offset_in_world(*meeting.before, *meeting.again).norm());
    return largest_of_nine_tenths(missed);
}

/// How far nine in ten look another way, at most.
double turn_of_rad(const std::vector<Meeting>& meetings) {
    std::vector<double> turns_rad;
    for (const Meeting& meeting : meetings)
        turns_rad.push_back(meeting.before->cam_from_world.rotation.angularDistance(
            meeting.again->cam_from_world.rotation));
    return largest_of_nine_tenths(turns_rad);
}

/// Places of a round, as most have them.
std::size_t usual_places(const std::vector<Meeting>& meetings) {
    std::vector<std::size_t> places;
    for (const Meeting& meeting : meetings) places.push_back(meeting.apart);
    return median_of(std::move(places));
}

/// From each stop to the next; empty where one of them was not placed.
std::vector<std::optional<double>> steps_of(const Walk& walk) {
    std::vector<std::optional<double>> steps;
    for (std::size_t index = 0; index + 1 < walk.size(); ++index) {
        const View* const from = walk[index].view;
        const View* const to = walk[index + 1].view;
        const bool is_known = from != nullptr && to != nullptr;
        steps.push_back(is_known ? std::optional(offset_in_world(*from, *to).norm())
                                 : std::nullopt);
    }
    return steps;
}

double median_of_known(const std::vector<std::optional<double>>& steps) {
    std::vector<double> known;
    for (const std::optional<double>& step : steps)
        if (step) known.push_back(*step);
    return median_of(std::move(known));
}

/// Whether rounds, most of them, end with a leap back to their first place. Two places have no such
/// end.
bool leap_back(const std::vector<std::optional<double>>& steps, const Rounds& rounds,
               std::size_t places, double median_step) {
    constexpr double kLeap = 1.8;
    if (usual_places(rounds.meetings) == 2) return true;
    std::vector<std::vector<double>> from_place(places);
    for (std::size_t index = 0; index < steps.size(); ++index)
        if (steps[index]) from_place[rounds.place_of[index]].push_back(*steps[index]);
    return std::any_of(from_place.begin(), from_place.end(), [&](std::vector<double>& ends) {
        return quantile_of(std::move(ends), 0.5) > kLeap * median_step;
    });
}

/// What each photograph of a round has changed since the round before, by rounds.
using ChangesOfRounds = std::map<std::size_t, std::vector<Eigen::Vector3d>>;

/// Whether rounds, most of them, change all by the same: clearly by more than the changes scatter.
bool change_alike(const ChangesOfRounds& changes_of_rounds) {
    constexpr double kClearly = 2.0;
    std::vector<double> shifts;
    std::vector<double> scatters;
    for (const auto& [round, changes] : changes_of_rounds) {
        if (changes.size() < 2) continue;
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& change : changes) mean += change;
        mean /= static_cast<double>(changes.size());
        for (const Eigen::Vector3d& change : changes) {
            shifts.push_back(mean.norm());
            scatters.push_back((change - mean).norm());
        }
    }
    return median_of(shifts) > kClearly * median_of(scatters);
}

/// Whether a round lies beside the one before by the same everywhere, as the cameras see it: two
/// lenses of one rig, rows of different height, a turntable before which the camera was moved.
/// A hand that misses its places does so each time in another direction; and where the middle of a
/// walk around is not that of the thing, it is in the world that a side's places are shifted by the
/// same, while the cameras turn.
bool lie_side_by_side(const std::vector<Meeting>& meetings, double most_offset) {
    ChangesOfRounds offsets;
    for (const Meeting& meeting : meetings) {
        const Eigen::Vector3d offset = offset_in_world(*meeting.before, *meeting.again);
        if (offset.norm() <= most_offset)
            offsets[meeting.round].push_back(meeting.before->cam_from_world.rotation * offset);
    }
    return change_alike(offsets);
}

/// The same for where cameras look: a slider or a turntable that goes its way again with the camera
/// tilted.
bool look_beside(const std::vector<Meeting>& meetings, double most_turn_rad) {
    ChangesOfRounds turns;
    for (const Meeting& meeting : meetings) {
        const Eigen::AngleAxisd turn(meeting.again->cam_from_world.rotation *
                                     meeting.before->cam_from_world.rotation.conjugate());
        if (turn.angle() <= most_turn_rad)
            turns[meeting.round].emplace_back(turn.angle() * turn.axis());
    }
    return change_alike(turns);
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
    // Fewer are met again by chance, of few photographs taken to and fro.
    constexpr std::size_t kFewestMeetings = 4;
    // A missing photograph takes away up to two meetings.
    constexpr double kLeastMet = 0.65;
    const Walk walk = walk_of(model, photographs);
    const std::vector<std::optional<double>> steps = steps_of(walk);
    const double step = median_of_known(steps);
    if (!(step > 0)) return std::nullopt;
    for (std::size_t places = 2; 2 * places <= walk.size(); ++places) {
        Rounds rounds = rounds_of(places, walk);
        const std::size_t all = rounds.meetings.size();
        rounds.meetings = without_missing(std::move(rounds.meetings), step);
        const std::size_t met = rounds.meetings.size();
        if (met < std::max(places, kFewestMeetings) ||
            static_cast<double>(met) < kLeastMet * static_cast<double>(all))
            continue;
        const double missed_share = missed_of(rounds.meetings) / step;
        if (missed_share > kSamePlace || turn_of_rad(rounds.meetings) > kSameView_rad) continue;
        if (!leap_back(steps, rounds, places, step)) continue;
        if (lie_side_by_side(rounds.meetings, kSamePlace * step)) continue;
        if (look_beside(rounds.meetings, kSameView_rad)) continue;
        const std::size_t usual = usual_places(rounds.meetings);
        return WalkInRounds{static_cast<int>(usual),
                            static_cast<int>((walk.size() + usual - 1) / usual), missed_share};
    }
    return std::nullopt;
}

}  // namespace lumi
