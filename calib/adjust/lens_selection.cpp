#include "calib/adjust/lens_selection.h"

#include <algorithm>
#include <numeric>

#include "calib/adjust/bundle_problem.h"
#include "calib/lens/lens_faults.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

/// A form that was fitted, and where everything then stood.
struct FittedForm {
    LensTrial trial;
    Capture capture;
    bool is_usable = false;
};

BundleAdjustmentOptions with_form(const Capture& capture, int camera_index, const LensForm& form,
                                  BundleAdjustmentOptions adjustment) {
    std::vector<std::vector<int>> held;
    for (std::size_t camera = 0; camera < capture.cameras.size(); ++camera) {
        held.push_back(constant_lens_parameters(capture, camera, adjustment));
    }
    held[static_cast<std::size_t>(camera_index)] = form.held;
    adjustment.held_lens_parameters = std::move(held);
    return adjustment;
}

/// The fit with the least error whose form is nested in `form`; else the capture as it came.
const Capture& start_for(const LensForm& form, const std::vector<FittedForm>& fitted,
                         const Capture& capture) {
    const FittedForm* best = nullptr;
    for (const FittedForm& other : fitted) {
        if (!other.is_usable || !is_nested_in(other.trial.form.model, form.model)) continue;
        if (free_parameters(other.trial.form) > free_parameters(form)) continue;
        if (best == nullptr || other.trial.residual_sum_px2 < best->trial.residual_sum_px2) {
            best = &other;
        }
    }
    return best == nullptr ? capture : best->capture;
}

/// What is held must stand where it stood in `original`, wherever the fit it starts from had it.
Camera start_lens(const Camera& original, const Camera& fitted, const LensForm& form) {
    Camera lens = in_model(fitted, form.model);
    const Camera held = in_model(original, form.model);
    for (const int index : form.held) {
        lens.parameters[static_cast<std::size_t>(index)] =
            held.parameters[static_cast<std::size_t>(index)];
    }
    return lens;
}

FittedForm fit_form(const LensForm& form, const Capture& start, const Camera& original,
                    int camera_index, const BundleAdjustmentOptions& adjustment,
                    Progress& progress) {
    FittedForm fitted{{}, start, false};
    Camera& lens = fitted.capture.cameras[static_cast<std::size_t>(camera_index)];
    lens = start_lens(original, lens, form);
    fitted.trial.form = form;
    try {
        const BundleFit fit = fit_bundle(
            fitted.capture, with_form(fitted.capture, camera_index, form, adjustment), progress);
        validate(lens, std::string(name_of(form.model)));
        fitted.trial.residual_sum_px2 = fit.residual_sum_px2;
        fitted.trial.residuals = fit.residuals;
        fitted.trial.lens = lens;
        fitted.is_usable = true;
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::kInterrupted) throw;
    }
    return fitted;
}

/// Distance of a pixel from the principal point in focal lengths.
double distance_in_focal_lengths(const Camera& lens, const Eigen::Vector2d& pixel) {
    return (pixel - principal_point_px(lens)).cwiseQuotient(focal_length_px(lens)).norm();
}

/// lens_fault as far out as the picture reaches.
std::string fault_in_picture(const Camera& lens) {
    double farthest = 0;
    for (const int x : {0, lens.width_px}) {
        for (const int y : {0, lens.height_px}) {
            farthest = std::max(farthest, distance_in_focal_lengths(lens, Eigen::Vector2d(x, y)));
        }
    }
    return lens_fault(lens, farthest);
}

/// lens_fault as far out as the camera's photographs show points.
std::string fault_within(const Capture& capture, int camera_index) {
    const Camera& lens = capture.cameras[static_cast<std::size_t>(camera_index)];
    double farthest = 0;
    for (const ScenePoint& point : capture.points) {
        for (const Observation& seen : point.track) {
            const View& view = capture.views[static_cast<std::size_t>(seen.view_index)];
            if (view.camera_index != camera_index) continue;
            farthest = std::max(farthest, distance_in_focal_lengths(lens, seen.pixel));
        }
    }
    return lens_fault(lens, farthest);
}

double bic_of(const LensTrial& trial) { return choose_lens({trial}).trials.front().bic; }

/// Cross-validates the form of least BIC, then those with no more parameters, in the order of BIC.
void predict(std::vector<FittedForm>& fitted, int camera_index,
             const BundleAdjustmentOptions& adjustment, const LensSelectionOptions& options,
             int threads, Progress& progress) {
    std::vector<std::size_t> order(fitted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> bic;
    for (const FittedForm& form : fitted) bic.push_back(bic_of(form.trial));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return bic[a] < bic[b]; });
    const std::vector<HeldOutFold>* best = nullptr;
    const int most_parameters = free_parameters(fitted[order.front()].trial.form);
    for (const std::size_t index : order) {
        FittedForm& form = fitted[index];
        form.trial.not_predicted = fault_within(form.capture, camera_index);
        if (!form.trial.not_predicted.empty()) continue;
        form.trial.fault_beyond_seen = fault_in_picture(form.trial.lens);
        if (free_parameters(form.trial.form) > most_parameters) {
            form.trial.not_predicted = "more than BIC asks for";
            continue;
        }
        if (best != nullptr &&
            predicts_worse_surely(fitted_views(form.capture, camera_index, options.held_out),
                                  *best)) {
            form.trial.not_predicted = "fits worse than others predict";
            continue;
        }
        try {
            form.trial.folds = predict_held_out_views(
                form.capture, camera_index,
                with_form(form.capture, camera_index, form.trial.form, adjustment),
                options.held_out, threads, progress);
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::kInterrupted) throw;
            form.trial.not_predicted = "cannot be fitted without some of the views";
            continue;
        }
        if (!any_usable(form.trial.folds)) {
            form.trial.folds.clear();
            form.trial.not_predicted = "no view sees what two others see";
            continue;
        }
        if (best == nullptr) best = &form.trial.folds;
    }
}

}  // namespace

std::vector<LensForm> every_lens_form() {
    std::vector<LensForm> forms;
    for (const LensModel model : {LensModel::kSimplePinhole, LensModel::kPinhole,
                                  LensModel::kSimpleRadial, LensModel::kRadial, LensModel::kOpenCv,
                                  LensModel::kFullOpenCv, LensModel::kOpenCvFisheye}) {
        forms.push_back(with_principal_point_held(model));
        forms.push_back(all_free(model));
    }
    return forms;
}

std::vector<LensForm> forms_of_given_lens(LensModel model) {
    return {all_held(model), with_principal_point_held(model), all_free(model)};
}

std::optional<LensChoice> select_lens(const Capture& capture, int camera_index,
                                      const std::vector<LensForm>& forms,
                                      const BundleAdjustmentOptions& adjustment,
                                      const LensSelectionOptions& options, int threads,
                                      Progress& progress) {
    const auto views =
        std::count_if(capture.views.begin(), capture.views.end(),
                      [&](const View& view) { return view.camera_index == camera_index; });
    if (views < options.min_views) return std::nullopt;
    const Capture part = representative_part(
        capture, std::min(options.max_observations,
                          options.max_observations_per_view * static_cast<int>(views)));
    const Camera& original = capture.cameras[static_cast<std::size_t>(camera_index)];
    std::vector<LensForm> ascending = forms;
    std::stable_sort(ascending.begin(), ascending.end(), [](const auto& a, const auto& b) {
        return free_parameters(a) < free_parameters(b);
    });
    progress.begin("comparing lens models", 0);
    std::vector<FittedForm> fitted;
    for (const LensForm& form : ascending) {
        FittedForm next = fit_form(form, start_for(form, fitted, part), original, camera_index,
                                   adjustment, progress);
        if (next.is_usable) fitted.push_back(std::move(next));
    }
    if (fitted.empty()) return std::nullopt;
    predict(fitted, camera_index, adjustment, options, threads, progress);
    std::vector<LensTrial> trials;
    for (FittedForm& form : fitted) trials.push_back(std::move(form.trial));
    return choose_lens(std::move(trials));
}

Capture representative_part(const Capture& capture, int max_observations) {
    constexpr int kColumns = 8;
    constexpr int kRows = 6;
    if (count_observations(capture) <= static_cast<std::size_t>(max_observations)) return capture;

    std::vector<std::size_t> order(capture.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return capture.points[a].track.size() > capture.points[b].track.size();
    });
    const auto cell_of = [&](const Observation& seen) {
        const View& view = capture.views[static_cast<std::size_t>(seen.view_index)];
        const Camera& camera = camera_of(capture, view);
        const auto step = [](double share, int steps) {
            return std::clamp(static_cast<int>(share * steps), 0, steps - 1);
        };
        const int column = step(seen.pixel.x() / camera.width_px, kColumns);
        const int row = step(seen.pixel.y() / camera.height_px, kRows);
        return static_cast<std::size_t>((seen.view_index * kRows + row) * kColumns + column);
    };
    std::vector<int> filled(capture.views.size() * kColumns * kRows, 0);
    std::vector<char> is_taken(capture.points.size(), 0);
    int taken = 0;
    // The fair share grows until there are enough: pictures are covered evenly where they can be.
    for (int share = 1; taken < max_observations; ++share) {
        for (const std::size_t index : order) {
            const ScenePoint& point = capture.points[index];
            if (is_taken[index] != 0 || taken >= max_observations) continue;
            const bool is_wanted =
                std::any_of(point.track.begin(), point.track.end(),
                            [&](const Observation& seen) { return filled[cell_of(seen)] < share; });
            if (!is_wanted) continue;
            is_taken[index] = 1;
            taken += static_cast<int>(point.track.size());
            for (const Observation& seen : point.track) ++filled[cell_of(seen)];
        }
    }
    Capture part{capture.cameras, capture.views, {}};
    for (std::size_t index = 0; index < capture.points.size(); ++index) {
        if (is_taken[index] != 0) part.points.push_back(capture.points[index]);
    }
    return part;
}

}  // namespace lumi
