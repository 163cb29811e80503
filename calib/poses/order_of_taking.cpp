#include "calib/poses/order_of_taking.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "calib/doctor/capture_reason.h"
#include "calib/ingest/photograph_order.h"
#include "calib/matching/pair_verification.h"
#include "calib/matching/photograph_matching.h"
#include "calib/poses/firm_joints.h"
#include "calib/poses/incremental_mapping.h"
#include "calib/poses/pair_agreement.h"
#include "calib/poses/stated_uncertainty.h"
#include "calib/poses/walk_in_rounds.h"
#include "calib/work/error.h"
#include "calib/work/formatted.h"

namespace lumi {
namespace {

/// Photographs that follow each other, from how far: where hardly anything is seen three times in a
/// row, those a little farther on help.
constexpr std::array<int, 2> kStepsApart{1, 3};

/// Which pairs are of photographs that follow each other, at most so many steps apart.
class Followers {
 public:
    Followers(int steps, const std::vector<Photograph>& photographs)
        : steps_(steps), places_(places_in_order(photographs)) {}

    [[nodiscard]] bool are(int first, int second) const {
        return std::abs(places_[static_cast<std::size_t>(first)] -
                        places_[static_cast<std::size_t>(second)]) <= steps_;
    }

    [[nodiscard]] std::vector<std::pair<int, int>> pairs() const {
        std::vector<std::pair<int, int>> pairs;
        const int photographs = static_cast<int>(places_.size());
        for (int first = 0; first < photographs; ++first)
            for (int second = first + 1; second < photographs; ++second)
                if (are(first, second)) pairs.emplace_back(first, second);
        return pairs;
    }

 private:
    int steps_;
    std::vector<int> places_;
};

/// Matched again leniently where there are features: that they follow each other speaks for them.
MatchedPhotographs with_pairs_of(const Followers& followers, const MappingJob& job,
                                 const MatchedPhotographs& matched) {
    MatchedPhotographs followed = without_features(matched);
    if (matched.features.empty()) {
        std::erase_if(followed.pairs, [&](const VerifiedPair& pair) {
            return !followers.are(pair.first, pair.second);
        });
    } else {
        followed.pairs = verify_pairs(match_pairs(matched.features, followers.pairs(),
                                                  kLenientMatching, job.threads, job.progress),
                                      job.groups.cameras, matched.photographs,
                                      job.lens_is_calibrated, {}, job.threads, job.progress);
    }
    return followed;
}

/// Pairs that follow each other, and the others that agree with the model that these make.
struct SortedPairs {
    MatchedPhotographs agreeing;
    std::size_t judged = 0;
    std::size_t set_aside = 0;
};

SortedPairs sorted_by(const Capture& model, const Followers& followers, MatchedPhotographs followed,
                      const MappingJob& job, const MatchedPhotographs& matched) {
    SortedPairs sorted{std::move(followed)};
    for (const JudgedPair& judged :
         judge_pairs(model, job.photographs, matched.photographs, matched.pairs, job.progress)) {
        const VerifiedPair& pair = matched.pairs[judged.index];
        ++sorted.judged;
        if (!judged.is_agreeing()) {
            ++sorted.set_aside;
        } else if (!followers.are(pair.first, pair.second)) {
            sorted.agreeing.pairs.push_back(pair);
        }
    }
    return sorted;
}

/// Who walks takes even steps, and does not photograph each side before the next step: of such an
/// order most steps would be those of a hand that stands still, and others leap.
bool leaps(const Capture& model) {
    constexpr double kMostRatio = 4.0;
    std::vector<View> views = model.views;
    std::sort(views.begin(), views.end(),
              [](const View& a, const View& b) { return comes_before(a.name, b.name); });
    std::vector<double> steps;
    for (std::size_t i = 1; i < views.size(); ++i)
        steps.push_back((centre_in_world(views[i].cam_from_world) -
                         centre_in_world(views[i - 1].cam_from_world))
                            .norm());
    std::sort(steps.begin(), steps.end());
    const std::size_t fifth = steps.size() / 5;
    return steps[steps.size() - 1 - fifth] > kMostRatio * steps[fifth];
}

/// Why the order is asked.
enum class Cause {
    kContradiction,  ///< Pairs or the walk deny it: what looks alike may have been mistaken.
    kMissing,        ///< Many photographs were not placed: they share too little to be sure of.
};

/// Sides that look alike do not hang together firmly, either: where photographs are missing, even
/// two pairs that see another side are a contradiction.
std::optional<Cause> cause_to_ask(const Capture& model, const MappingJob& job,
                                  const MatchedPhotographs& matched) {
    constexpr double kMany = 0.2;
    const PairAgreement agreement = compare_with_pairs(model, job.photographs, matched.photographs,
                                                       matched.pairs, job.progress);
    const double total = static_cast<double>(job.photographs.size());
    const bool lacks_many = total - static_cast<double>(model.views.size()) > kMany * total;
    if (agreement.is_contradiction() || (agreement.is_mistaken() && lacks_many) ||
        walk_in_rounds(model, job.photographs))
        return Cause::kContradiction;
    return lacks_many ? std::optional(Cause::kMissing) : std::nullopt;
}

/// Whether the walk that a model tells of is the one that the photographs were taken on: what it
/// denies, if anything, was seen from another side altogether.
bool is_walk(const Capture& model, const MappingJob& job, const MatchedPhotographs& matched) {
    const PairAgreement agreement = compare_with_pairs(model, job.photographs, matched.photographs,
                                                       matched.pairs, job.progress);
    return agreement.doubtful_in_order == 0 && !leaps(model) &&
           !walk_in_rounds(model, job.photographs) &&
           (agreement.is_mistaken() || !agreement.is_contradiction());
}

std::string warning_of(Cause cause, const SortedPairs& pairs, std::size_t added) {
    if (cause == Cause::kMissing)
        return formatted(
            "%zu photographs share so little with the others that they were placed only because "
            "they follow each other by name; look at the drawing",
            added);
    return std::string(code_of(CaptureReason::kRepeated)) +
           formatted(
               ": things look alike: of %zu pairs of photographs %zu say otherwise than those that "
               "follow each other by name, which were believed; look at the drawing",
               pairs.judged, pairs.set_aside);
}

/// The question of find_model_in_order, put to a job with evidence of its own.
class OrderQuestion {
 public:
    OrderQuestion(const MappingJob& job, const MatchedPhotographs& matched, Cause cause,
                  std::size_t placed)
        : job_(job),
          matched_(matched),
          cause_(cause),
          least_views_(placed + (cause == Cause::kMissing ? 1 : 0)) {}

    [[nodiscard]] std::optional<Capture> mapped_from(MatchedPhotographs matched) const {
        std::optional<Capture> mapped = map_incrementally(job_, matched);
        if (mapped && mapped->views.size() < least_views_) return std::nullopt;
        return mapped;
    }

    [[nodiscard]] std::optional<SecondModel> finished(const Capture& mapped,
                                                      LensPolicy policy) const {
        JointCheck joints = with_firm_joints(job_, mapped);
        SecondModel model;
        model.mapped = std::move(joints.mapped);
        model.joint_trouble = std::move(joints.trouble);
        model.refined = model.mapped;
        refine(model.refined, policy, job_.options, job_.threads, job_.evidence, job_.progress);
        const bool is_whole = model.refined.views.size() >= least_views_;
        if (!is_whole || !is_walk(model.refined, job_, matched_)) return std::nullopt;
        // Few photographs that are sure are better than all of which none is.
        const bool is_sure = place_uncertainty(model.refined, job_.evidence.views).views == 0;
        if (cause_ == Cause::kMissing && !is_sure) return std::nullopt;
        return model;
    }

 private:
    const MappingJob& job_;
    const MatchedPhotographs& matched_;
    Cause cause_;
    std::size_t least_views_;
};

/// A model, and the pairs that it was made from.
struct Answer {
    SecondModel model;
    SortedPairs pairs;
};

/// Empty where no model comes of it, or none that is a walk.
std::optional<Answer> answer_of(const OrderQuestion& question, const Followers& followers,
                                const MappingJob& own_job, const MatchedPhotographs& matched,
                                LensPolicy policy) {
    try {
        MatchedPhotographs followed = with_pairs_of(followers, own_job, matched);
        const auto chain = question.mapped_from(followed);
        if (!chain) return std::nullopt;
        SortedPairs pairs = sorted_by(*chain, followers, std::move(followed), own_job, matched);
        const auto mapped = question.mapped_from(pairs.agreeing);
        if (!mapped) return std::nullopt;
        auto model = question.finished(*mapped, policy);
        if (!model) return std::nullopt;
        return Answer{std::move(*model), std::move(pairs)};
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::kDegenerateCapture) throw;
        return std::nullopt;
    }
}

}  // namespace

std::optional<SecondModel> find_model_in_order(const MappingJob& job, MatchedPhotographs& matched,
                                               LensPolicy policy, const Capture& refined) {
    if (job.options.mapper != PoseProgram::kLumi) return std::nullopt;
    const std::optional<Cause> cause = cause_to_ask(refined, job, matched);
    if (!cause) return std::nullopt;
    job.progress.note(std::string(*cause == Cause::kMissing
                                      ? "many photographs are missing"
                                      : "what looks alike may have been mistaken") +
                      ": asking those that follow each other");
    const std::size_t placed = refined.views.size();
    for (const int steps : kStepsApart) {
        PoseEvidence evidence;
        const MappingJob own_job = with_evidence(job, evidence);
        const OrderQuestion question(own_job, matched, *cause, placed);
        auto answer =
            answer_of(question, Followers(steps, job.photographs), own_job, matched, policy);
        if (!answer) continue;
        answer->model.warning =
            warning_of(*cause, answer->pairs, answer->model.refined.views.size() - placed);
        tell_of_second_model(job.evidence, std::move(evidence));
        matched.pairs = std::move(answer->pairs.agreeing.pairs);
        return std::move(answer->model);
    }
    return std::nullopt;
}

}  // namespace lumi
