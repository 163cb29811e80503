#include "calib/poses/own_focal_lengths.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "calib/doctor/capture_reason.h"
#include "calib/lens/lens_form.h"
#include "calib/poses/residual_pattern.h"
#include "calib/poses/supposed_adjustment.h"
#include "calib/work/error.h"
#include "calib/work/formatted.h"

namespace lumi {
namespace {

double mean_focal_length_px(const Camera& lens) { return focal_length_px(lens).mean(); }

/// By the name of a view, its focal length over the geometric mean of those that share its lens.
using Zooms = std::map<std::string, double>;

/// Lenses that views share but for the focal length, from one model of them to the next.
class SharedLenses {
 public:
    explicit SharedLenses(const Capture& shared) : lenses_(shared.cameras) {
        for (const View& view : shared.views) lens_of_view_[view.name] = view.camera_index;
    }

    /// The index of the shared lens.
    [[nodiscard]] int of(const View& view) const { return lens_of_view_.at(view.name); }

    [[nodiscard]] Zooms zooms_of(const Capture& own) const {
        std::map<int, double> log_sum;
        std::map<int, int> count;
        for (const View& view : own.views) {
            log_sum[of(view)] += std::log(mean_focal_length_px(camera_of(own, view)));
            ++count[of(view)];
        }
        Zooms zooms;
        for (const View& view : own.views) {
            const double mean_px = std::exp(log_sum[of(view)] / count[of(view)]);
            zooms[view.name] = mean_focal_length_px(camera_of(own, view)) / mean_px;
        }
        return zooms;
    }

    /// Scales each view's picture about its principal point as if it had been taken with
    /// `factor_of` times the focal length. As distortion bends directions, the lens stays the same
    /// otherwise.
    template <class FactorOf>
    void scale_pictures(Capture& capture, const FactorOf& factor_of) const {
        for (ScenePoint& point : capture.points) {
            for (Observation& seen : point.track) {
                const View& view = capture.views[static_cast<std::size_t>(seen.view_index)];
                const Eigen::Vector2d middle_px =
                    principal_point_px(lenses_[static_cast<std::size_t>(of(view))]);
                seen.pixel = middle_px + factor_of(view) * (seen.pixel - middle_px);
            }
        }
    }

    /// With the lenses shared again, each of the mean focal length.
    [[nodiscard]] Capture with_shared_cameras(Capture own, const Zooms& zooms) const {
        std::vector<Camera> shared = lenses_;
        for (View& view : own.views) {
            shared[static_cast<std::size_t>(of(view))] =
                with_focal_length_scaled(camera_of(own, view), 1 / zooms.at(view.name));
            view.camera_index = of(view);
        }
        own.cameras = std::move(shared);
        return own;
    }

 private:
    std::vector<Camera> lenses_;
    std::map<std::string, int> lens_of_view_;
};

/// Each view with a camera of its own: the one that it shares, zoomed.
Capture with_own_cameras(Capture shared, const Zooms& zooms) {
    std::vector<Camera> own;
    for (View& view : shared.views) {
        const auto zoom = zooms.find(view.name);
        own.push_back(with_focal_length_scaled(camera_of(shared, view),
                                               zoom == zooms.end() ? 1.0 : zoom->second));
        view.camera_index = static_cast<int>(own.size()) - 1;
    }
    shared.cameras = std::move(own);
    return shared;
}

/// The mapped model with the lenses of the refined one, which may have fewer views: a lens that
/// none of these has stays as it is.
Capture with_refined_lenses(Capture mapped, const Capture& refined) {
    std::map<std::string, int> refined_lens_of_view;
    for (const View& view : refined.views) refined_lens_of_view[view.name] = view.camera_index;
    for (const View& view : mapped.views) {
        const auto found = refined_lens_of_view.find(view.name);
        if (found == refined_lens_of_view.end()) continue;
        mapped.cameras[static_cast<std::size_t>(view.camera_index)] =
            refined.cameras[static_cast<std::size_t>(found->second)];
    }
    return mapped;
}

/// Whether own focal lengths are worth their number. A camera that turned while the rows were read
/// out stretches its pictures, too; then three parameters of that kind explain more than three of a
/// lens that moved.
bool are_worth_it(const MappingJob& job, const Capture& mapped) {
    const double limit_px = job.options.max_reprojection_error_px;
    const auto cost_px2 = [&](Supposition supposition) {
        return adjust_supposing(
                   supposition, mapped,
                   job.lens_is_calibrated ? SupposedLens::kHeld : SupposedLens::kMiddleHeld,
                   limit_px, job.progress)
            .cost_px2;
    };
    return own_scales_explain_better(mapped, job.lens_is_calibrated, limit_px, job.progress) &&
           cost_px2(Supposition::kShifted) < cost_px2(Supposition::kTurning);
}

/// What was compared is told with the first view of each lens.
void tell_of_lenses(PoseEvidence& evidence, const SharedLenses& shared, const Capture& own,
                    PoseEvidence of_own, const PoseEvidence& of_shared) {
    std::set<int> told;
    for (const View& view : own.views) {
        if (!told.insert(shared.of(view)).second) continue;
        const LensEvidence& of_all = of_shared.lenses[static_cast<std::size_t>(shared.of(view))];
        LensEvidence& first = of_own.lenses[static_cast<std::size_t>(view.camera_index)];
        first.choice = of_all.choice;
        first.dropped = of_all.dropped;
    }
    evidence.lenses = std::move(of_own.lenses);
    evidence.views = std::move(of_own.views);
    evidence.noise_px = of_own.noise_px;
}

std::string warning_of(const Zooms& zooms) {
    const auto [least, most] =
        std::minmax_element(zooms.begin(), zooms.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; });
    return std::string(code_of(CaptureReason::kZoom)) +
           formatted(
               ": focal lengths differ by up to %.1f %% between photographs that share a "
               "lens, as where the focus moves; each was given its own. Next time, lock the "
               "focus",
               100 * (most->second / least->second - 1));
}

std::optional<SecondModel> model_with_own_focal_lengths(const MappingJob& job, LensPolicy policy,
                                                        const Capture& mapped,
                                                        const Capture& refined) {
    const auto refined_by = [&](LensPolicy by, Capture capture, PoseEvidence& evidence) {
        refine(capture, by, job.options, job.threads, evidence, job.progress);
        return capture;
    };
    SecondModel model;
    model.mapped = with_refined_lenses(mapped, refined);
    if (!are_worth_it(job, model.mapped)) return std::nullopt;

    const SharedLenses lenses(model.mapped);
    PoseEvidence of_first;
    const Capture first =
        refined_by(LensPolicy::kFocalLength, with_own_cameras(model.mapped, {}), of_first);
    const Zooms zooms = lenses.zooms_of(first);
    Capture steady = lenses.with_shared_cameras(first, zooms);
    lenses.scale_pictures(steady, [&](const View& view) { return 1 / zooms.at(view.name); });
    PoseEvidence of_steady;
    steady = refined_by(policy, std::move(steady), of_steady);
    lenses.scale_pictures(steady, [&](const View& view) { return zooms.at(view.name); });
    const SharedLenses chosen(steady);

    PoseEvidence of_own;
    model.refined =
        refined_by(LensPolicy::kFocalLength, with_own_cameras(std::move(steady), zooms), of_own);
    if (model.refined.views.size() < refined.views.size()) return std::nullopt;
    tell_of_lenses(job.evidence, chosen, model.refined, std::move(of_own), of_steady);
    model.warning = warning_of(chosen.zooms_of(model.refined));
    return model;
}

}  // namespace

std::optional<SecondModel> find_own_focal_lengths(const MappingJob& job, LensPolicy policy,
                                                  const Capture& mapped, const Capture& refined) {
    if (!job.options.shared_lens || policy == LensPolicy::kHeld ||
        !residual_pattern(refined).is_zoomed()) {
        return std::nullopt;
    }
    job.progress.begin("asking whether the focus moved between photographs", 0);
    try {
        return model_with_own_focal_lengths(job, policy, mapped, refined);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::kDegenerateCapture) throw;
        return std::nullopt;  // The model that there is stands.
    }
}

}  // namespace lumi
