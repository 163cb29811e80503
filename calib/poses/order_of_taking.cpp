#include "calib/poses/order_of_taking.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "calib/doctor/capture_reason.h"
#include "calib/matching/pair_verification.h"
#include "calib/matching/photograph_matching.h"
#include "calib/poses/firm_joints.h"
#include "calib/poses/pair_agreement.h"
#include "calib/work/error.h"
#include "calib/work/formatted.h"

namespace lumi {
namespace {

/// Photographs that follow each other, from how far: where hardly anything is seen three times in a
/// row, those a little farther on help.
constexpr std::array<int, 2> kStepsApart{1, 3};

/// Of photographs at most so many steps apart, matched again leniently where there are features:
/// that they follow each other speaks for them.
MatchedPhotographs with_pairs_within(int steps, const MappingJob& job,
                                     const MatchedPhotographs& matched) {
    MatchedPhotographs within = without_features(matched);
    std::erase_if(within.pairs,
                  [steps](const VerifiedPair& pair) { return pair.second - pair.first > steps; });
    if (matched.features.empty()) return within;
    std::vector<std::pair<int, int>> followed;
    const int photographs = static_cast<int>(matched.features.size());
    for (int first = 0; first < photographs; ++first)
        for (int second = first + 1; second <= std::min(first + steps, photographs - 1); ++second)
            followed.emplace_back(first, second);
    within.pairs = verify_pairs(
        match_pairs(matched.features, followed, kLenientMatching, job.threads, job.progress),
        job.groups.cameras, matched.photographs, job.lens_is_calibrated, {}, job.threads,
        job.progress);
    return within;
}

/// Pairs that follow each other, and the others that agree with the model that these make.
struct SortedPairs {
    MatchedPhotographs agreeing;
    std::size_t judged = 0;
    std::size_t set_aside = 0;
};

SortedPairs sorted_by(const Capture& model, int steps, MatchedPhotographs followed,
                      const MappingJob& job, const MatchedPhotographs& matched) {
    SortedPairs sorted{std::move(followed)};
    for (const JudgedPair& judged :
         judge_pairs(model, job.photographs, matched.photographs, matched.pairs)) {
        const VerifiedPair& pair = matched.pairs[judged.index];
        ++sorted.judged;
        if (!judged.is_agreeing()) {
            ++sorted.set_aside;
        } else if (pair.second - pair.first > steps) {
            sorted.agreeing.pairs.push_back(pair);
        }
    }
    return sorted;
}

/// Who walks takes even steps, and does not photograph each side before the next step: of such an
/// order most steps would be those of a hand that stands still, and others leap. Views are in the
/// order of the photographs.
bool leaps(const Capture& model) {
    constexpr double kMostRatio = 4.0;
    std::vector<double> steps;
    for (std::size_t i = 1; i < model.views.size(); ++i)
        steps.push_back((centre_in_world(model.views[i].cam_from_world) -
                         centre_in_world(model.views[i - 1].cam_from_world))
                            .norm());
    std::sort(steps.begin(), steps.end());
    const std::size_t fifth = steps.size() / 5;
    return steps[steps.size() - 1 - fifth] > kMostRatio * steps[fifth];
}

/// Whether the walk that a model tells of is the one that the photographs were taken on.
bool is_walk(const Capture& model, const MappingJob& job, const MatchedPhotographs& matched) {
    const PairAgreement agreement =
        compare_with_pairs(model, job.photographs, matched.photographs, matched.pairs);
    return agreement.doubtful_in_order == 0 && agreement.is_mistaken() && !leaps(model);
}

std::string warning_of(const SortedPairs& pairs) {
    return std::string(code_of(CaptureReason::kRepeated)) +
           formatted(
               ": things look alike: of %zu pairs of photographs %zu say otherwise than those that "
               "follow each other by name, which were believed; look at the drawing",
               pairs.judged, pairs.set_aside);
}

/// The question of find_model_in_order, put to a job with evidence of its own.
class OrderQuestion {
 public:
    OrderQuestion(const MappingJob& job, const MatchedPhotographs& matched, const Capture& first)
        : job_(job), matched_(matched), first_(first) {}

    [[nodiscard]] std::optional<Capture> mapped_from(MatchedPhotographs matched) const {
        std::optional<Capture> mapped = map_incrementally(job_, matched);
        if (mapped && mapped->views.size() < first_.views.size()) return std::nullopt;
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
        const bool is_whole = model.refined.views.size() >= first_.views.size();
        if (!is_whole || !is_walk(model.refined, job_, matched_)) return std::nullopt;
        return model;
    }

 private:
    const MappingJob& job_;
    const MatchedPhotographs& matched_;
    const Capture& first_;
};

}  // namespace

std::optional<SecondModel> find_model_in_order(const MappingJob& job, MatchedPhotographs& matched,
                                               LensPolicy policy, const Capture& refined) {
    const bool is_contradicted =
        compare_with_pairs(refined, job.photographs, matched.photographs, matched.pairs)
            .is_contradiction();
    if (!is_contradicted || job.options.mapper != "lumi") return std::nullopt;
    job.progress.note("pairs contradict each other: asking those that follow each other");
    PoseEvidence evidence;
    const MappingJob own_job{
        job.photographs, job.groups,         job.options, job.lens_is_calibrated,
        job.refine_lens, job.scratch_folder, job.threads, job.progress,
        evidence};
    const OrderQuestion question(own_job, matched, refined);
    try {
        for (const int steps : kStepsApart) {
            evidence = {};
            MatchedPhotographs followed = with_pairs_within(steps, job, matched);
            const auto chain = question.mapped_from(followed);
            if (!chain) continue;
            SortedPairs pairs = sorted_by(*chain, steps, std::move(followed), job, matched);
            const auto mapped = question.mapped_from(pairs.agreeing);
            if (!mapped) continue;
            std::optional<SecondModel> model = question.finished(*mapped, policy);
            if (!model) continue;
            tell_of_second_model(job.evidence, std::move(evidence));
            model->warning = warning_of(pairs);
            matched.pairs = std::move(pairs.agreeing.pairs);
            return model;
        }
        return std::nullopt;
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::kDegenerateCapture) throw;
        return std::nullopt;
    }
}

}  // namespace lumi
