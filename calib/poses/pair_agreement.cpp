#include "calib/poses/pair_agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "calib/capture/one_place.h"
#include "calib/ingest/photograph_order.h"
#include "calib/matching/pair_geometry.h"
#include "calib/poses/pair_ties.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr std::size_t kMinInliers = 30;   ///< Fewer are in doubt themselves.
constexpr double kToleranceShare = 0.01;  ///< Of the longer side.
/// Of all pairs: such that the model denies. Chance verifies no pair with so many matches: even few
/// of them say that something is wrong.
constexpr double kMaxContradictedShare = 0.03;
/// Of all matches. Photographs in order were seen above 0.99, noisy and low-contrast ones at 0.975.
constexpr double kMinAgreeingShare = 0.95;
/// Where no pair is denied: a facade of repeated windows was seen at 0.89. Some folded models have
/// as much, but deny pairs, if only 3 % of them and less.
constexpr double kMinAgreeingShareOfUndenied = 0.85;
/// Of pairs that follow each other: of captures whose sides do not look alike none was seen, of
/// folded models two in ten and more.
constexpr double kMaxDoubtfulShare = 0.05;
constexpr double kMinMistakenTurn_deg = 15.0;
/// Matches of a denied pair over those of the chain: 0.31 and less of the windows of a facade whose
/// cameras stand within 10 mm of the truth, up to 0.74 and more of boxes with four equal sides that
/// were folded.
constexpr double kOutweighedShare = 0.4;

/// The angle between the second ray and the plane that the first ray and the base line span; where
/// there is no base line, and the first ray.
double epipolar_angle_rad(const Eigen::Vector3d& first_ray, const Eigen::Vector3d& second_ray,
                          const Rigid3& second_from_first) {
    const Eigen::Vector3d turned = (second_from_first.rotation * first_ray).normalized();
    if (second_from_first.translation.isZero(0)) {
        return std::atan2(turned.cross(second_ray).norm(), turned.dot(second_ray));
    }
    const Eigen::Vector3d normal = second_from_first.translation.normalized().cross(turned);
    // Along the base line every ray is in the plane.
    if (normal.norm() < 1e-6) return 0.0;
    return std::asin(std::min(1.0, std::abs(normal.normalized().dot(second_ray.normalized()))));
}

/// How many of a pair's matches lie near the epipolar lines of the model.
std::size_t count_agreeing(const VerifiedPair& pair, const Capture& capture, const View& first,
                           const View& second, const std::vector<ColmapPhotograph>& features) {
    const Camera& first_lens = camera_of(capture, first);
    const Camera& second_lens = camera_of(capture, second);
    Rigid3 second_from_first = second.cam_from_world * inverse(first.cam_from_world);
    if (are_at_one_place(first.cam_from_world, second.cam_from_world))
        second_from_first.translation.setZero();
    const double longer_px = std::max(second_lens.width_px, second_lens.height_px);
    const double tolerance_rad = kToleranceShare * longer_px / focal_length_px(second_lens).mean();
    const auto& first_px = features[static_cast<std::size_t>(pair.first)].keypoints_px;
    const auto& second_px = features[static_cast<std::size_t>(pair.second)].keypoints_px;
    std::size_t agreeing = 0;
    for (const FeatureMatch& match : pair.inliers) {
        const Eigen::Vector3d ray = unproject(first_lens, first_px[match.first].cast<double>());
        const Eigen::Vector3d seen = unproject(second_lens, second_px[match.second].cast<double>());
        if (epipolar_angle_rad(ray, seen, second_from_first) <= tolerance_rad) ++agreeing;
    }
    return agreeing;
}

/// Between the rotation that the pair's matches tell and the model's; empty where they tell none.
std::optional<double> turn_deg(const VerifiedPair& pair, const Capture& capture, const View& first,
                               const View& second, const std::vector<ColmapPhotograph>& features) {
    const VerifiedPair alone{0, 1, pair.configuration, pair.inliers};
    const PairGeometry geometry =
        pair_geometry_of(alone,
                         {{0, features[static_cast<std::size_t>(pair.first)].keypoints_px},
                          {1, features[static_cast<std::size_t>(pair.second)].keypoints_px}},
                         {{camera_of(capture, first), true}, {camera_of(capture, second), true}});
    if (!geometry.second_from_first) return std::nullopt;
    const Rigid3 second_from_first = second.cam_from_world * inverse(first.cam_from_world);
    return geometry.second_from_first->angularDistance(second_from_first.rotation) * 180.0 /
           std::numbers::pi;
}

using ViewOfPhotograph = std::vector<const View*>;

/// Null where a photograph was not placed.
ViewOfPhotograph views_of(const Capture& capture, const std::vector<Photograph>& photographs) {
    std::map<std::string, const View*> view_of_name;
    for (const View& view : capture.views) view_of_name.emplace(view.name, &view);
    ViewOfPhotograph views;
    for (const Photograph& photograph : photographs) {
        const auto view = view_of_name.find(photograph.name);
        views.push_back(view == view_of_name.end() ? nullptr : view->second);
    }
    return views;
}

}  // namespace

bool PairAgreement::is_contradiction() const {
    const bool denies_pairs = contradicted >= 2 && contradicted_share > kMaxContradictedShare;
    const bool denies_order =
        doubtful_in_order >= 2 && doubtful_in_order > kMaxDoubtfulShare * in_order;
    return denies_pairs || denies_order ||
           agreeing_share < (contradicted > 0 ? kMinAgreeingShare : kMinAgreeingShareOfUndenied);
}

bool PairAgreement::is_mistaken() const {
    return contradicted + outweighed + doubtful_in_order >= 2 &&
           contradicted_turn_deg > kMinMistakenTurn_deg;
}

std::vector<JudgedPair> judge_pairs(const Capture& capture,
                                    const std::vector<Photograph>& photographs,
                                    const std::vector<ColmapPhotograph>& features,
                                    const std::vector<VerifiedPair>& pairs,
                                    const Progress& progress) {
    const ViewOfPhotograph views = views_of(capture, photographs);
    std::vector<JudgedPair> judged;
    std::vector<PairTie> ties;
    for (std::size_t index = 0; index < pairs.size(); ++index) {
        progress.throw_if_interrupted();
        const VerifiedPair& pair = pairs[index];
        const View* const first = views[static_cast<std::size_t>(pair.first)];
        const View* const second = views[static_cast<std::size_t>(pair.second)];
        if (first == nullptr || second == nullptr || pair.inliers.size() < kMinInliers) continue;
        judged.push_back(
            {index, pair.inliers.size(), count_agreeing(pair, capture, *first, *second, features)});
        if (!judged.back().is_denied())
            ties.push_back({pair.first, pair.second, judged.back().agreeing});
    }
    const PairTies all(static_cast<int>(photographs.size()), std::move(ties));
    for (JudgedPair& pair : judged)
        pair.tied = all.between(pairs[pair.index].first, pairs[pair.index].second);
    return judged;
}

PairAgreement compare_with_pairs(const Capture& capture, const std::vector<Photograph>& photographs,
                                 const std::vector<ColmapPhotograph>& features,
                                 const std::vector<VerifiedPair>& pairs, const Progress& progress) {
    const std::vector<JudgedPair> judged =
        judge_pairs(capture, photographs, features, pairs, progress);
    const ViewOfPhotograph views = views_of(capture, photographs);
    const std::vector<int> places = places_in_order(photographs);
    const auto turned = [&](const VerifiedPair& pair) {
        return turn_deg(pair, capture, *views[static_cast<std::size_t>(pair.first)],
                        *views[static_cast<std::size_t>(pair.second)], features);
    };
    PairAgreement agreement;
    std::size_t matches = 0;
    std::size_t denied = 0;
    std::size_t agreeing = 0;
    std::vector<double> turns_deg;
    for (const JudgedPair& pair : judged) {
        progress.throw_if_interrupted();
        const VerifiedPair& verified = pairs[pair.index];
        const bool is_in_order = std::abs(places[static_cast<std::size_t>(verified.first)] -
                                          places[static_cast<std::size_t>(verified.second)]) == 1;
        if (is_in_order) ++agreement.in_order;
        // It takes long, and is not needed of others.
        const bool may_be_mistaken = pair.is_denied() || (is_in_order && !pair.is_agreeing());
        const std::optional<double> turn = may_be_mistaken ? turned(verified) : std::nullopt;
        const bool is_doubtful = is_in_order && turn && *turn > kMinMistakenTurn_deg;
        if (is_doubtful) ++agreement.doubtful_in_order;
        const bool is_outweighed =
            static_cast<double>(pair.matches) < kOutweighedShare * static_cast<double>(pair.tied);
        if (is_outweighed && pair.is_denied()) {
            ++agreement.outweighed;
            continue;
        }
        ++agreement.pairs;
        matches += is_outweighed ? pair.agreeing : pair.matches;
        agreeing += pair.agreeing;
        if (pair.is_denied()) {
            ++agreement.contradicted;
            denied += pair.matches;
        }
        if (turn && (pair.is_denied() || is_doubtful)) turns_deg.push_back(*turn);
    }
    agreement.contradicted_turn_deg = median_of(std::move(turns_deg));
    if (matches > 0) {
        agreement.agreeing_share = static_cast<double>(agreeing) / static_cast<double>(matches);
        agreement.contradicted_share =
            std::max(static_cast<double>(denied) / static_cast<double>(matches),
                     static_cast<double>(agreement.contradicted) / agreement.pairs);
    }
    return agreement;
}

}  // namespace lumi
